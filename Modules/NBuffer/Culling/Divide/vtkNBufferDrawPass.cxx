// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDrawPass.h"

#include "vtkNBufferPropertyKeys.h"
#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferSurface.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkWindow.h"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <unordered_set>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferDrawPass);
vtkInformationKeyMacro(vtkNBufferDrawPass, KEPT_WHOLE, Integer);

namespace
{
/// What a mapper knows of the passes of its last draws; empty if it cannot be reached.
std::vector<vtkInformation*> GetLastPasses(vtkMapper* mapper)
{
  vtkOpenGLPolyDataMapper* draws = vtkNBufferSurface::GetDrawingMapper(mapper);
  return draws ? vtkNBufferProtectedMembers::GetLastPasses(draws) : std::vector<vtkInformation*>();
}
}

struct vtkNBufferDrawPass::Registry
{
  std::mutex Mutex; ///< Windows may be drawn by several threads.
  std::map<vtkWindow*, vtkNBufferDrawPass*> Passes;
};

const std::shared_ptr<vtkNBufferDrawPass::Registry>& vtkNBufferDrawPass::GetRegistry()
{
  static const auto registry = std::make_shared<Registry>();
  return registry;
}

vtkSmartPointer<vtkNBufferDrawPass> vtkNBufferDrawPass::Get(vtkWindow* window)
{
  const std::shared_ptr<Registry>& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry->Mutex);
  vtkSmartPointer<vtkNBufferDrawPass> pass = registry->Passes[window];
  if (!pass)
  {
    pass = vtkSmartPointer<vtkNBufferDrawPass>::New();
    pass->Owner = registry;
    pass->Window = window;
    registry->Passes[window] = pass;
  }
  return pass;
}

vtkNBufferDrawPass::~vtkNBufferDrawPass()
{
  if (this->Owner)
  {
    const std::lock_guard<std::mutex> lock(this->Owner->Mutex);
    this->Owner->Passes.erase(this->Window);
  }
}

void vtkNBufferDrawPass::Follow(vtkWindow* window, vtkProp** props, int count)
{
  vtkSmartPointer<vtkNBufferDrawPass> pass;
  {
    const std::lock_guard<std::mutex> lock(GetRegistry()->Mutex);
    const auto found = GetRegistry()->Passes.find(window);
    if (found == GetRegistry()->Passes.end())
    {
      return;
    }
    pass = found->second;
  }
  std::unordered_set<vtkMapper*> mappers;
  for (const auto& [address, user] : pass->Users)
  {
    mappers.insert(user.Actor ? user.Actor->GetMapper() : nullptr);
  }
  for (int i = 0; i < count; ++i)
  {
    auto* actor = vtkActor::SafeDownCast(props[i]);
    if (actor && actor->GetMapper() && mappers.count(actor->GetMapper()))
    {
      pass->AddUser(actor);
      pass->HasFollowers = true;
    }
  }
}

vtkNBufferDrawPass::User& vtkNBufferDrawPass::AddUser(vtkActor* actor)
{
  if (this->Users.size() >= this->UsersToCheck)
  {
    for (auto user = this->Users.begin(); user != this->Users.end();)
    {
      user = user->second.Actor ? std::next(user) : this->Users.erase(user);
    }
    this->UsersToCheck = 2 * this->Users.size() + 1;
  }
  User& user = this->Users[actor];
  int count = 0;
  if (this->HasOtherMapper(actor))
  {
    const User former = std::exchange(user, {});
    this->RemoveFrom(former);
    count = former.Count;
  }
  if (!user.Actor)
  {
    user = { actor, actor->GetMapper(), count };
    vtkInformation* keys = vtkNBufferPropertyKeys::Get(actor);
    // Passes that are added while the renderer draws come after this one.
    const int place = vtkNBufferPropertyKeys::CountPasses(keys);
    if (vtkNBufferPropertyKeys::AddPass(keys, this))
    {
      for (vtkInformation* last : GetLastPasses(user.Mapper))
      {
        vtkNBufferPropertyKeys::AddPassToCopy(last, this, place);
      }
    }
  }
  return user;
}

void vtkNBufferDrawPass::RemoveFrom(const User& user)
{
  vtkNBufferPropertyKeys::RemovePass(user.Actor->GetPropertyKeys(), this);
  const bool isShared = std::any_of(this->Users.begin(), this->Users.end(),
    [&user](const auto& other)
    { return other.second.Actor && other.second.Mapper == user.Mapper; });
  if (!isShared)
  {
    for (vtkInformation* last : GetLastPasses(user.Mapper))
    {
      vtkNBufferPropertyKeys::RemovePassFromCopy(last, this);
    }
  }
}

bool vtkNBufferDrawPass::HasOtherMapper(vtkActor* actor) const
{
  const auto user = this->Users.find(actor);
  return user != this->Users.end() && user->second.Actor &&
    user->second.Mapper != actor->GetMapper();
}

bool vtkNBufferDrawPass::AttachAgain(vtkActor* actor)
{
  return vtkNBufferPropertyKeys::AddPass(vtkNBufferPropertyKeys::Get(actor), this);
}

void vtkNBufferDrawPass::Attach(vtkActor* actor)
{
  ++this->AddUser(actor).Count;
}

void vtkNBufferDrawPass::Detach(vtkActor* actor)
{
  const auto found = this->Users.find(actor);
  vtkMapper* mapper = actor->GetMapper();
  const bool isKept = mapper && mapper == found->second.Mapper && IsKeptWhole(mapper);
  if (isKept || --found->second.Count > 0)
  {
    return;
  }
  const User user = found->second;
  this->Users.erase(found);
  this->RemoveFrom(user);
  if (this->HasFollowers)
  {
    this->RemoveFromFollowers();
  }
}

void vtkNBufferDrawPass::RemoveFromFollowers()
{
  std::unordered_set<vtkMapper*> attached;
  for (const auto& [address, user] : this->Users)
  {
    attached.insert(user.Actor && user.Count > 0 ? user.Actor->GetMapper() : nullptr);
  }
  this->HasFollowers = false;
  for (auto found = this->Users.begin(); found != this->Users.end();)
  {
    const User user = found->second;
    vtkMapper* mapper = user.Actor ? user.Actor->GetMapper() : nullptr;
    const bool isAttached = user.Count > 0;
    const bool follows =
      !isAttached && mapper && (attached.count(mapper) > 0 || IsKeptWhole(mapper));
    this->HasFollowers = this->HasFollowers || follows;
    found = isAttached || follows ? std::next(found) : this->Users.erase(found);
    if (user.Actor && !isAttached && !follows)
    {
      this->RemoveFrom(user);
    }
  }
}

bool vtkNBufferDrawPass::IsUsedBy(vtkMapper* mapper) const
{
  const std::vector<vtkInformation*> lasts = GetLastPasses(mapper);
  return std::any_of(lasts.begin(), lasts.end(),
           [this](vtkInformation* last) { return vtkNBufferPropertyKeys::HasPass(last, this); }) ||
    std::any_of(this->Users.begin(), this->Users.end(),
      [mapper](const auto& entry)
      { return entry.second.Actor && entry.second.Actor->GetMapper() == mapper; });
}

void vtkNBufferDrawPass::KeepWhole(vtkMapper* mapper)
{
  mapper->GetInformation()->Set(KEPT_WHOLE(), 1);
}

bool vtkNBufferDrawPass::IsKeptWhole(vtkMapper* mapper)
{
  return mapper->GetInformation()->Has(KEPT_WHOLE()) != 0;
}

bool vtkNBufferDrawPass::SetShaderParameters(
  vtkShaderProgram*, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (this->Callback)
  {
    this->Callback(mapper, prop);
  }
  return true;
}
VTK_ABI_NAMESPACE_END

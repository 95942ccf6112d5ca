// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferObservedObjects.h"

#include "vtkCommand.h"
#include "vtkObject.h"

#include <atomic>
#include <limits>
#include <mutex>
#include <unordered_map>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

struct vtkNBufferObservedObjects::Record
{
  std::atomic<bool> Changed{ false };
  std::atomic<bool> Lost{ false };
  std::mutex Mutex; ///< Guards Commands.
  std::unordered_map<vtkObject*, vtkCommand*> Commands;
};

/// Observes one object. Only that object refers to the command, so that the command is destroyed
/// when its observer is removed.
class vtkNBufferObservedObjects::Command : public vtkCommand
{
public:
  Command(vtkObject* object, std::shared_ptr<Record> record)
    : Object(object)
    , Shared(std::move(record))
  {
  }

  void Execute(vtkObject* object, unsigned long, void*) override
  {
    this->Shared->Changed = true;
    this->IsDone = true;
    object->RemoveObserver(this);
  }

  /// Remove the observer, which is not needed any more.
  void Withdraw()
  {
    this->IsDone = true;
    this->Object->RemoveObserver(this);
  }

protected:
  ~Command() override
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->Shared->Commands.erase(this->Object);
    if (!this->IsDone)
    {
      // VTK destroys the observers of an object when nothing refers to the object any more.
      const bool isDeleted = this->Object->GetReferenceCount() <= 0;
      (isDeleted ? this->Shared->Changed : this->Shared->Lost) = true;
    }
  }

private:
  vtkObject* Object;
  std::shared_ptr<Record> Shared;
  bool IsDone = false;
};

vtkNBufferObservedObjects::vtkNBufferObservedObjects()
  : Shared(std::make_shared<Record>())
{
}

vtkNBufferObservedObjects::~vtkNBufferObservedObjects()
{
  std::unordered_map<vtkObject*, vtkCommand*> commands;
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    commands.swap(this->Shared->Commands);
  }
  for (const auto& [object, command] : commands)
  {
    static_cast<Command*>(command)->Withdraw();
  }
}

bool vtkNBufferObservedObjects::Add(vtkObject* object)
{
  Command* command = nullptr;
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    if (this->Shared->Commands.count(object) > 0)
    {
      return true;
    }
    if (this->Shared->Commands.size() >= MaximumSize)
    {
      return false;
    }
    command = new Command(object, this->Shared);
    this->Shared->Commands.emplace(object, command);
  }
  // The highest priority: another observer that is called first could abort the event.
  object->AddObserver(vtkCommand::ModifiedEvent, command, std::numeric_limits<float>::infinity());
  command->Delete();
  return true;
}

bool vtkNBufferObservedObjects::TakeChange()
{
  return this->Shared->Changed.exchange(false);
}

bool vtkNBufferObservedObjects::TakeLoss()
{
  return this->Shared->Lost.exchange(false);
}

std::size_t vtkNBufferObservedObjects::GetSize() const
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  return this->Shared->Commands.size();
}
VTK_ABI_NAMESPACE_END

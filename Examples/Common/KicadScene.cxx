// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneKinds.h"

#include "Compressed.h"
#include "KicadBoard.h"
#include "Parts.h"

#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVRMLImporter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
namespace fs = std::filesystem;
using Actors = std::vector<vtkSmartPointer<vtkActor>>;

constexpr int Slots = 80;
constexpr double Pitch = 22.0; // millimetres
const glm::dvec3 Middle = { 0.0, 0.0, 0.0 };
constexpr double UnitOfModels = 2.54; // millimetres: KiCad's VRML is in tenths of an inch

std::vector<fs::path> FindBoards(const fs::path& folder)
{
  std::vector<fs::path> boards;
  for (const fs::path& place : { folder, folder / "boards" })
  {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(place, ignored))
    {
      if (entry.path().extension() == ".kicad_pcb")
      {
        boards.push_back(entry.path());
      }
    }
  }
  std::sort(boards.begin(), boards.end());
  return boards;
}

/// The models, each read once.
class Library
{
public:
  explicit Library(const fs::path& folder)
  {
    const char* named = std::getenv("KICAD6_3DMODEL_DIR");
    this->Folders = { folder / "kicad-3dmodels", folder / ".." / "kicad-3dmodels",
      named ? fs::path(named) : fs::path(), "/usr/share/kicad/3dmodels" };
  }

  struct Model
  {
    Actors Pieces; ///< What the importer makes of the model; none if it cannot be read.
    vtkSmartPointer<vtkPolyDataMapper> Whole; ///< All pieces as one mesh with colours.
  };

  /// Returns a model, which is read by the first call.
  Model& Get(const std::string& name)
  {
    const auto [entry, isNew] = this->Models.try_emplace(name);
    const std::string file = isNew ? this->FindFile(name) : std::string();
    if (!file.empty())
    {
      vtkNew<vtkVRMLImporter> importer;
      importer->SetFileName(file.c_str());
      for (vtkActor* actor : ImportActors(importer))
      {
        // Some nodes of VRML become actors without anything to draw.
        if (GetMesh(actor))
        {
          entry->second.Pieces.emplace_back(actor);
        }
      }
    }
    return entry->second;
  }

  /// Returns all of a model as one mesh with colours; nullptr if it cannot be read.
  vtkPolyDataMapper* GetWhole(const std::string& name)
  {
    Model& model = this->Get(name);
    if (!model.Whole && !model.Pieces.empty())
    {
      vtkNew<vtkAppendPolyData> all;
      for (vtkActor* piece : model.Pieces)
      {
        all->AddInputData(MakeColored(piece));
      }
      all->Update();
      model.Whole = vtkSmartPointer<vtkPolyDataMapper>::New();
      model.Whole->SetInputData(all->GetOutput());
      model.Whole->SetScalarModeToUseCellData();
    }
    return model.Whole;
  }

private:
  static vtkPolyData* GetMesh(vtkActor* actor)
  {
    if (!actor->GetMapper() || actor->GetMapper()->GetNumberOfInputConnections(0) == 0)
    {
      return nullptr;
    }
    actor->GetMapper()->Update();
    auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
    return mesh && mesh->GetNumberOfCells() > 0 ? mesh : nullptr;
  }

  static vtkSmartPointer<vtkPolyData> MakeColored(vtkActor* actor)
  {
    vtkNew<vtkTransform> place;
    place->SetMatrix(actor->GetMatrix());
    vtkNew<vtkTransformFilter> moved;
    moved->SetTransform(place);
    moved->SetInputData(GetMesh(actor));
    moved->Update();
    vtkSmartPointer<vtkPolyData> data = moved->GetPolyDataOutput();
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("color");
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(data->GetNumberOfCells());
    for (int i = 0; i < 3; ++i)
    {
      colors->FillComponent(i, std::round(255.0 * actor->GetProperty()->GetDiffuseColor()[i]));
    }
    data->GetCellData()->Initialize();
    data->GetCellData()->SetScalars(colors);
    return data;
  }

  std::string FindFile(const std::string& model) const
  {
    // What follows the variable; KiCad itself takes VRML in place of STEP.
    const std::size_t end = model.find('}');
    fs::path name =
      end == std::string::npos ? model : model.substr(std::min(end + 2, model.size()));
    name.replace_extension(".wrl");
    for (const fs::path& folder : this->Folders)
    {
      std::error_code ignored;
      if (!folder.empty() && fs::is_regular_file(folder / name, ignored))
      {
        return (folder / name).string();
      }
    }
    return std::string();
  }

  std::vector<fs::path> Folders;
  std::map<std::string, Model> Models;
};

/// Returns the matrix from a model to the scene. The middle of the board's outline and layers is at
/// (0, 0, z), y points up.
vtkSmartPointer<vtkMatrix4x4> MakePlacement(
  const KicadBoard& board, const KicadPart& part, double z)
{
  vtkNew<vtkTransform> place;
  place->Translate(part.X - 0.5 * (board.Low[0] + board.High[0]),
    0.5 * (board.Low[1] + board.High[1]) - part.Y, (part.IsBelow ? -0.5 : 0.5) * board.Thickness);
  place->RotateZ(part.Angle);
  if (part.IsBelow)
  {
    place->RotateY(180.0);
    place->RotateZ(180.0);
  }
  place->Translate(part.Offset);
  place->RotateZ(-part.Rotation[2]);
  place->RotateY(-part.Rotation[1]);
  place->RotateX(-part.Rotation[0]);
  place->Scale(
    UnitOfModels * part.Scale[0], UnitOfModels * part.Scale[1], UnitOfModels * part.Scale[2]);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->DeepCopy(place->GetMatrix());
  matrix->SetElement(2, 3, matrix->GetElement(2, 3) + z);
  return matrix;
}

KicadBoard ReadBoard(const fs::path& file)
{
  return ParseFile(file.string(), ReadKicadBoard);
}

class BoardBuilder
{
public:
  BoardBuilder(const fs::path& folder, const Progress& progress)
    : Models(folder)
    , Report(progress)
  {
    vtkNew<vtkCubeSource> cube;
    this->Box = MakePartMapper(cube);
  }

  void AddBoard(const KicadBoard& board, double z)
  {
    AddPart(this->Result, this->Box, { 0.0, 0.0, z },
      { board.High[0] - board.Low[0], board.High[1] - board.Low[1], board.Thickness })
      ->GetProperty()
      ->SetColor(0.1, 0.35, 0.2);
  }

  /// One actor.
  void AddWhole(const KicadBoard& board, const KicadPart& part, double z)
  {
    vtkPolyDataMapper* mapper = this->Models.GetWhole(part.Model);
    if (!mapper)
    {
      ++this->Missing;
      return;
    }
    AddPart(this->Result, mapper)->SetUserMatrix(MakePlacement(board, part, z));
    ++this->Found;
  }

  /// All that the importer makes of it.
  void AddPieces(const KicadBoard& board, const KicadPart& part, double z)
  {
    const Actors& pieces = this->Models.Get(part.Model).Pieces;
    const vtkSmartPointer<vtkMatrix4x4> place = MakePlacement(board, part, z);
    for (vtkActor* piece : pieces)
    {
      vtkNew<vtkMatrix4x4> matrix;
      vtkMatrix4x4::Multiply4x4(place, piece->GetMatrix(), matrix);
      auto actor = vtkSmartPointer<vtkActor>::New();
      actor->SetMapper(piece->GetMapper());
      actor->SetProperty(piece->GetProperty());
      actor->SetUserMatrix(matrix);
      this->Result.Actors.push_back(actor);
    }
    ++(pieces.empty() ? this->Missing : this->Found);
  }

  Scene Finish(const std::string& name)
  {
    if (this->Found == 0)
    {
      throw std::runtime_error(name +
        ": none of the models of its parts was found or could be read; they are in Debian's "
        "kicad-packages3d, and KICAD6_3DMODEL_DIR may name their folder");
    }
    if (this->Missing > 0)
    {
      this->Report(name + ": " + std::to_string(this->Missing) + " of " +
        std::to_string(this->Missing + this->Found) + " parts without a model that can be read");
    }
    this->Result.Name = name;
    return std::move(this->Result);
  }

private:
  Library Models;
  const NBufferExamples::Progress& Report;
  vtkSmartPointer<vtkPolyDataMapper> Box;
  Scene Result;
  int Found = 0;
  int Missing = 0;
};

/// Around the cage, 0.9 m from its middle line.
CameraPose LookFromOutside(int frame, int frames)
{
  const double angle = 2.0 * vtkMath::Pi() * (frame + 0.25) / frames;
  const double length = 0.5 * Slots * Pitch + 500.0;
  return { { 900.0 * std::cos(angle), 300.0, length * std::sin(angle) }, Middle, { 0.0, 1.0, 0.0 },
    60.0, 50.0, 4000.0 };
}

/// Between two boards, eight times another two, once around in each gap, looking along the boards.
CameraPose LookBetween(int frame, int frames)
{
  constexpr int gaps = 8;
  const int gap = frame * gaps / frames;
  const double share = static_cast<double>(frame) * gaps / frames - gap;
  const int slot = (7 + 11 * gap) % (Slots - 1);
  // Nearer to the boards that one looks at from behind: their parts are on the other side.
  const double z = (slot + 0.75 - 0.5 * (Slots - 1)) * Pitch;
  const double yaw = 2.0 * vtkMath::Pi() * share;
  const glm::dvec3 eye = { 40.0 * (share - 0.5), 10.0, z };
  return { eye, { eye.x + std::cos(yaw), eye.y + std::sin(yaw), z - 0.15 }, { 0.0, 0.0, 1.0 }, 60.0,
    0.5, 2500.0 };
}

Scene LoadBoard(const fs::path& file, const Progress& progress)
{
  const KicadBoard board = ReadBoard(file);
  BoardBuilder builder(file.parent_path(), progress);
  builder.AddBoard(board, 0.0);
  for (const KicadPart& part : board.Parts)
  {
    builder.AddPieces(board, part, 0.0);
  }
  Scene scene = builder.Finish(file.stem().string());
  // Low over the board, looking at its middle.
  const double radius =
    0.5 * std::max(board.High[0] - board.Low[0], board.High[1] - board.Low[1]) + 10.0;
  const auto look = [radius](int frame, int frames) -> CameraPose
  {
    const double angle = 2.0 * vtkMath::Pi() * frame / frames;
    return { { radius * std::cos(angle), radius * std::sin(angle), 25.0 }, Middle,
      { 0.0, 0.0, 1.0 }, 50.0, 2.0, 500.0 };
  };
  scene.Paths = { { "over", MakePathOf(look) } };
  return scene;
}

/// The name of a cage without what says that it is to be in pieces.
std::string GetFolder(const std::string& name)
{
  return std::regex_replace(name, std::regex("(.):actors$"), "$1");
}

Scene LoadCage(const fs::path& folder, bool inPieces, const Progress& progress)
{
  std::vector<KicadBoard> boards;
  for (const fs::path& file : FindBoards(folder))
  {
    boards.push_back(ReadBoard(file));
  }
  BoardBuilder builder(folder, progress);
  for (int slot = 0; slot < Slots; ++slot)
  {
    const KicadBoard& board = boards[static_cast<std::size_t>(slot) % boards.size()];
    const double z = (slot - 0.5 * (Slots - 1)) * Pitch;
    builder.AddBoard(board, z);
    for (const KicadPart& part : board.Parts)
    {
      if (inPieces)
      {
        builder.AddPieces(board, part, z);
      }
      else
      {
        builder.AddWhole(board, part, z);
      }
    }
  }
  Scene scene = builder.Finish(inPieces ? "card cage of actors" : "card cage");
  scene.UpAxis = 1;
  scene.Paths = { { "outside", MakePathOf(LookFromOutside) },
    { "between", MakePathOf(LookBetween) } };
  return scene;
}
}

bool IsKicadName(const std::string& name)
{
  const std::string folder = GetFolder(name);
  std::error_code ignored;
  return fs::path(name).extension() == ".kicad_pcb" ||
    (fs::is_directory(folder, ignored) && !FindBoards(folder).empty());
}

Scene LoadKicad(const std::string& name, const Progress& progress)
{
  const std::string folder = GetFolder(name);
  return fs::path(name).extension() == ".kicad_pcb" ? LoadBoard(name, progress)
                                                    : LoadCage(folder, folder != name, progress);
}

} // namespace NBufferExamples

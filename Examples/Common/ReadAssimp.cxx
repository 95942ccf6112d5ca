// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadAssimp.cxx
 * @brief Files of whole scenes that assimp reads: a part for each mesh of each node.
 */
#include "FileFormats.h"

#ifdef NBUFFER_HAS_ASSIMP

#include "Parts.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
vtkSmartPointer<vtkPolyData> MakeMesh(const aiMesh& mesh)
{
  const auto count = static_cast<vtkIdType>(mesh.mNumVertices);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const aiVector3D& point = mesh.mVertices[i];
    points->SetPoint(i, point.x, point.y, point.z);
  }
  vtkNew<vtkCellArray> cells;
  for (unsigned int i = 0; i < mesh.mNumFaces; ++i)
  {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices >= 3)
    {
      cells->InsertNextCell(static_cast<int>(face.mNumIndices));
      for (unsigned int j = 0; j < face.mNumIndices; ++j)
      {
        cells->InsertCellPoint(face.mIndices[j]);
      }
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  if (mesh.HasNormals())
  {
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const aiVector3D& normal = mesh.mNormals[i];
      normals->SetTuple3(i, normal.x, normal.y, normal.z);
    }
    data->GetPointData()->SetNormals(normals);
  }
  return data;
}

/// Walks through the nodes of a scene of assimp.
class Walker
{
public:
  Walker(const aiScene& from, const ReadOptions& options, Scene& to)
    : From(from)
    , Options(options)
    , To(to)
  {
    for (unsigned int i = 0; i < from.mNumMeshes; ++i)
    {
      const vtkSmartPointer<vtkPolyData> mesh = MakeMesh(*from.mMeshes[i]);
      this->Mappers.push_back(MakePartMapper(mesh));
    }
    this->Visit(*from.mRootNode, aiMatrix4x4());
  }

private:
  void Visit(const aiNode& node, const aiMatrix4x4& above)
  {
    const aiMatrix4x4 matrix = above * node.mTransformation;
    for (unsigned int i = 0; i < node.mNumMeshes; ++i)
    {
      this->AddPart(node, node.mMeshes[i], matrix);
    }
    for (unsigned int i = 0; i < node.mNumChildren; ++i)
    {
      this->Visit(*node.mChildren[i], matrix);
    }
  }

  void AddPart(const aiNode& node, unsigned int mesh, const aiMatrix4x4& place)
  {
    vtkPolyDataMapper* mapper = this->Mappers[mesh];
    if (mapper->GetInput()->GetNumberOfCells() == 0)
    {
      return;
    }
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    vtkNew<vtkMatrix4x4> matrix;
    for (unsigned int i = 0; i < 4; ++i)
    {
      for (unsigned int j = 0; j < 4; ++j)
      {
        matrix->SetElement(static_cast<int>(i), static_cast<int>(j), place[i][j]);
      }
    }
    if (!matrix->IsIdentity())
    {
      actor->SetUserMatrix(matrix);
    }
    this->Paint(actor, *this->From.mMeshes[mesh]);
    const std::string name = node.mName.C_Str();
    AddNamedPart(this->To, actor,
      !name.empty() ? name
                    : this->Options.Title + ", part " + std::to_string(this->To.Actors.size() + 1));
  }

  /// A part has the colour of its material or, if there is none, one by its number.
  void Paint(vtkActor* actor, const aiMesh& mesh)
  {
    PaintPart(actor, this->To.Actors.size(), 0.85);
    if (mesh.mMaterialIndex >= this->From.mNumMaterials)
    {
      return;
    }
    const aiMaterial& material = *this->From.mMaterials[mesh.mMaterialIndex];
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    aiColor3D color;
    if (std::string(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME &&
      material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS)
    {
      actor->GetProperty()->SetColor(std::clamp<double>(color.r, 0.0, 1.0),
        std::clamp<double>(color.g, 0.0, 1.0), std::clamp<double>(color.b, 0.0, 1.0));
    }
    float opacity = 1.0F;
    if (material.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS && opacity > 0.0F)
    {
      actor->GetProperty()->SetOpacity(std::min(opacity, 1.0F));
    }
  }

  const aiScene& From;
  const ReadOptions& Options;
  Scene& To;
  std::vector<vtkSmartPointer<vtkPolyDataMapper>> Mappers; ///< By the number of the mesh.
};

void ReadByAssimp(const std::string& path, const ReadOptions& options, Scene& scene)
{
  Assimp::Importer importer;
  const aiScene* read = importer.ReadFile(path,
    aiProcess_Triangulate | aiProcess_JoinIdenticalVertices | aiProcess_ValidateDataStructure);
  if (!read || !read->mRootNode)
  {
    throw std::runtime_error(std::string("assimp says: ") + importer.GetErrorString());
  }
  Scene parts;
  Walker(*read, options, parts);
  AddParts(scene, parts, options);
}
}

std::vector<FileFormat> GetAssimpFormats()
{
  std::vector<FileFormat> formats;
  std::string list; // "*.3d;*.3ds;..."
  Assimp::Importer().GetExtensionList(list);
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ';');)
  {
    const std::string ending = word.substr(std::min<std::size_t>(word.find('.'), word.size()));
    // Assimp turns the axes of most formats so that y points up, but not those of these.
    const bool isZ = ending == ".3mf" || ending == ".off" || ending == ".amf" || ending == ".dxf";
    // These hold no geometry by themselves, or something else under the same ending as a rule: of
    // STEP assimp reads IFC only, and of XML the meshes of Ogre.
    const std::set<std::string> unfit = { "", ".md5anim", ".md5camera", ".mot", ".raw", ".step",
      ".stp", ".vta", ".xml" };
    if (unfit.count(ending) == 0)
    {
      formats.push_back({ ending, "by assimp", ReadByAssimp, isZ ? 2 : 1 });
    }
  }
  return formats;
}

} // namespace NBufferExamples

#else

namespace NBufferExamples
{

std::vector<FileFormat> GetAssimpFormats()
{
  return {};
}

} // namespace NBufferExamples

#endif

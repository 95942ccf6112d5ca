// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Imported.h"

#include "vtkActorCollection.h"
#include "vtkImporter.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace NBufferExamples
{

std::vector<vtkSmartPointer<vtkActor>> ImportActors(vtkImporter* importer)
{
  // Only a place for the importer to put its actors; it never gets a context.
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  importer->SetRenderWindow(window);
  importer->Update();
  std::vector<vtkSmartPointer<vtkActor>> actors;
  if (vtkRenderer* filled = importer->GetRenderer())
  {
    vtkActorCollection* collection = filled->GetActors();
    collection->InitTraversal();
    while (vtkActor* actor = collection->GetNextActor())
    {
      actors.emplace_back(actor);
    }
    filled->RemoveAllViewProps();
  }
  return actors;
}

} // namespace NBufferExamples

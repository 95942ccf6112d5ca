// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CullCity.cxx
 * @brief A city of 15,328 buildings, each an actor, seen from a street. With --out it also says how
 * many props were drawn.
 */
#include "CameraPath.h"
#include "Example.h"
#include "LoadScene.h"

#include "vtkNBufferCuller.h"

#include <iostream>

int main(int argc, char* argv[])
{
  NBufferExamples::Example example("A city, without what its houses hide", "culler");
  const auto show = [&]()
  {
    const NBufferExamples::Scene city = NBufferExamples::LoadScene({ "city" }, { argv[0] });
    vtkRenderer* renderer = example.GetRenderer();
    city.AddTo(renderer);

    vtkNew<vtkNBufferCuller> culler;
    if (example.IsOn())
    {
      renderer->AddCuller(culler);
    }

    double bounds[6];
    city.GetBounds().GetBounds(bounds);
    const NBufferExamples::CameraPath path = NBufferExamples::MakePath(city, "street", 1, 1);
    NBufferExamples::ApplyPose(path.front(), bounds, renderer);
    example.Show("cull-city");
    std::cout << "cull-city: " << renderer->GetNumberOfPropsRendered() << " of "
              << city.Actors.size() << " props drawn, " << culler->GetNumberOfHiddenProps()
              << " found hidden\n";
  };
  return example.Run(argc, argv, show);
}

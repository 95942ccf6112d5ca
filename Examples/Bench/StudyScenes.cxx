// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StudyScenes.h"

#include <filesystem>

namespace NBufferBench
{

std::string StudyScene::GetPath(const std::string& folder) const
{
  return this->IsFile ? folder + "/" + this->Name : this->Name;
}

bool StudyScene::IsThere(const std::string& folder) const
{
  if (!this->IsFile)
  {
    return true;
  }
  // Without what LoadScene takes for a way to cut a map.
  const std::string path = this->GetPath(folder);
  std::error_code ignored;
  return std::filesystem::exists(path.substr(0, path.rfind(':')), ignored);
}

const std::vector<StudyScene>& GetStudyScenes()
{
  static const std::vector<StudyScene> scenes = {
    { "plant", false, { "inside", "around" }, true, 4, 3, 24, 4 },
    { "oa_thor.bsp:faces", true, { "walk" }, true, 6, 3, 40, 6 },
    { "oa_thor.bsp:clusters", true, { "walk" }, false, 6, 3, 40, 6 },
    { "ctf_inyard.bsp:faces", true, { "walk" }, false, 6, 3, 40, 6 },
    { "kicad", true, { "outside", "between" }, false, 3, 3, 8, 2 },
    { "kicad/boards/kit-dev-coldfire-xilinx_5213.kicad_pcb", true, { "over" }, false, 4, 3, 16, 3 },
    { "motorBike.obj.gz", true, { "orbit" }, false, 4, 3, 24, 3 },
  };
  return scenes;
}

const char* GetSceneCommand()
{
  return "Scripts/make-scenes.sh";
}

} // namespace NBufferBench

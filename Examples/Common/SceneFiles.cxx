// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneKinds.h"

#include "Compressed.h"
#include "FileFormats.h"
#include "ReaderMessages.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
namespace fs = std::filesystem;

/// Returns the ending of a name in lower case; of a .gz, that of the file inside.
std::string GetEnding(const std::string& name)
{
  std::string ending = fs::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".gz" ? GetEnding(fs::path(name).stem().string()) : ending;
}

/// A file or, if it is a .gz, a decompressed copy that lives as long as this object.
class PlainFile
{
public:
  explicit PlainFile(const std::string& name)
    : Path(name)
  {
    std::ifstream test(name, std::ios::binary);
    if (!test || fs::is_directory(name))
    {
      throw std::runtime_error("cannot open " + name);
    }
    if (fs::path(name).extension() != ".gz")
    {
      return;
    }
    const std::string contents = ReadMaybeCompressed(name);
    std::random_device random;
    this->Folder = fs::temp_directory_path() / ("nbuffer-" + std::to_string(random()));
    fs::create_directory(this->Folder);
    this->Path = this->Folder / fs::path(name).stem();
    std::ofstream file(this->Path, std::ios::binary);
    file.write(contents.data(), static_cast<std::streamsize>(contents.size()));
    if (!file.flush())
    {
      throw std::runtime_error("cannot write " + this->Path.string() + " to decompress " + name);
    }
  }
  ~PlainFile()
  {
    std::error_code ignored;
    if (!this->Folder.empty())
    {
      fs::remove_all(this->Folder, ignored);
    }
  }
  PlainFile(const PlainFile&) = delete;
  void operator=(const PlainFile&) = delete;

  std::string GetPath() const { return this->Path.string(); }

private:
  fs::path Path;
  fs::path Folder;
};

bool IsEmpty(const std::string& name)
{
  std::error_code ignored;
  return fs::is_regular_file(name, ignored) && fs::file_size(name, ignored) == 0;
}

const FileFormat& FindFormat(const std::string& name)
{
  std::error_code ignored;
  if (fs::is_directory(name, ignored))
  {
    throw std::runtime_error(name + " is a folder, and there is no .kicad_pcb in it");
  }
  const std::string ending = GetEnding(name);
  const FileFormat* format = FindFileFormat(ending);
  if (format && !format->Read)
  {
    // LoadScene() would have recognised it by what it contains.
    throw std::runtime_error(
      name + (IsEmpty(name) ? " is empty" : " is damaged, or is no " + format->Kind));
  }
  if (!format)
  {
    throw std::runtime_error("cannot tell how to read " + name + ": " +
      (ending.empty() ? "it has no ending" : "the ending " + ending + " is not known") +
      "; known are " + ListEndings());
  }
  return *format;
}

void ReadFile(const std::string& name, const FileFormat& format, bool splitRegions,
  const Progress& progress, Scene& scene)
{
  const PlainFile file(name);
  if (IsEmpty(file.GetPath()))
  {
    throw std::runtime_error(name + " is empty");
  }
  const std::size_t before = scene.Actors.size();
  std::string error;
  try
  {
    const ReaderMessages messages;
    const std::string title = fs::path(name).filename().string();
    format.Read(file.GetPath(), { title, splitRegions, messages }, scene);
    error = messages.GetFirstError();
    if (scene.Actors.size() == before || !format.NamesFiles)
    {
      messages.Check();
    }
  }
  catch (const std::exception& exception)
  {
    throw std::runtime_error(
      name + " is damaged, was cut short, or is not what its ending says; " + exception.what());
  }
  if (scene.Actors.size() == before)
  {
    throw std::runtime_error(name + ": nothing to draw was read, the file has no geometry");
  }
  if (!error.empty())
  {
    progress(name + " was read, but perhaps not all that belongs to it; VTK says: " + error);
  }
}
}

Scene ImportFiles(
  const std::vector<std::string>& names, bool splitRegions, const Progress& progress)
{
  Scene scene;
  for (const std::string& name : names)
  {
    const FileFormat& format = FindFormat(name);
    if (names.size() > 1 && !format.IsPart)
    {
      throw std::runtime_error(name +
        " is a scene by itself; only files of these endings go together: " + ListEndings(true));
    }
    if (&name != &names.front())
    {
      progress("reading " + name); // LoadScene() has reported the first one.
    }
    ReadFile(name, format, splitRegions, progress, scene);
    scene.UpAxis = format.UpAxis;
    scene.Name += (scene.Name.empty() ? "" : " ") + fs::path(name).filename().string();
  }
  if (!scene.GetBounds().IsValid())
  {
    throw std::runtime_error(scene.Name + ": nothing to draw was read, no part has an extent");
  }
  return scene;
}

} // namespace NBufferExamples

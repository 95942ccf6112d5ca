// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReaderMessages.h"

#include "vtkLogger.h"
#include "vtkObjectFactory.h"

#include <iostream>
#include <regex>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
/// Keeps the first error, or warning about an error, and drops everything else.
class ErrorKeeper : public vtkOutputWindow
{
public:
  static ErrorKeeper* New();
  vtkTypeMacro(ErrorKeeper, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    if (this->First.empty() && text)
    {
      this->First = text;
    }
  }
  void DisplayWarningText(const char* text) override
  {
    if (text && std::string(text).find("Error") != std::string::npos)
    {
      this->DisplayErrorText(text);
    }
  }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayDebugText(const char*) override {}

  std::string First;
};
vtkStandardNewMacro(ErrorKeeper);
}

ReaderMessages::ReaderMessages()
  : Previous(vtkOutputWindow::GetInstance())
  , Collector(vtkSmartPointer<ErrorKeeper>::New())
  , Verbosity(vtkLogger::GetCurrentVerbosityCutoff())
  , PreviousErrors(std::cerr.rdbuf(Errors.rdbuf()))
{
  vtkOutputWindow::SetInstance(this->Collector);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

ReaderMessages::~ReaderMessages()
{
  std::cerr.rdbuf(this->PreviousErrors);
  vtkOutputWindow::SetInstance(this->Previous);
  vtkLogger::SetStderrVerbosity(vtkLogger::ConvertToVerbosity(this->Verbosity));
}

std::string ReaderMessages::GetFirstError() const
{
  constexpr std::size_t moderate = 160;
  std::string text = static_cast<ErrorKeeper*>(this->Collector.GetPointer())->First;
  if (text.empty() && this->Errors.str().find("rror") != std::string::npos)
  {
    text = this->Errors.str();
  }
  text = text.substr(0, 4 * moderate);
  // "ERROR: In vtkFoo.cxx, line 12\nvtkFoo (0x1234): what has happened\n\n"
  for (const char* part :
    { "^[A-Za-z ]+: In [^\n]*\n", "^(\\w+ )?\\((0x)?[0-9a-fA-F]+\\): *", "^\\(nullptr\\): *" })
  {
    text = std::regex_replace(text, std::regex(part), "");
  }
  text = std::regex_replace(text, std::regex("\\s+"), " ");
  text = std::regex_replace(text, std::regex("^ | ?[.]? $"), "");
  return text.size() > moderate ? text.substr(0, moderate) + "..." : text;
}

void ReaderMessages::Check() const
{
  const std::string error = this->GetFirstError();
  if (!error.empty())
  {
    throw std::runtime_error("VTK says: " + error);
  }
}

} // namespace NBufferExamples

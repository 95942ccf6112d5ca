// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// GoogleTest's main. It collects VTK's messages from the start, and returns 125 (skipped), with the
// reason, if this VTK does not have the window class that the environment names.
#include "CullerTest.h"

#include "vtkAutoInit.h"

#include <iostream>

namespace
{
constexpr int Skipped = 125;
}

int main(int argc, char* argv[])
{
  testing::InitGoogleTest(&argc, argv);
  TakeMessages();
  if (!testing::GTEST_FLAG(list_tests))
  {
    const std::string fault = FindWindowFault();
    if (!fault.empty())
    {
      std::cout << "SKIPPED: " << fault << std::endl;
      return Skipped;
    }
  }
  const int result = RUN_ALL_TESTS();
  const testing::UnitTest& tests = *testing::UnitTest::GetInstance();
  return result == 0 && tests.skipped_test_count() > 0 && tests.successful_test_count() == 0
    ? Skipped
    : result;
}

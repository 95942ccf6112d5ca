// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

// CTest's SKIP_RETURN_CODE: a program whose every test was skipped must not read as passed.
constexpr int AllSkipped = 125;

int main(int argc, char** argv)
{
  ::testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  const ::testing::UnitTest* tests = ::testing::UnitTest::GetInstance();
  const bool skipped = tests->skipped_test_count() > 0 && tests->successful_test_count() == 0;
  return result == 0 && skipped ? AllSkipped : result;
}

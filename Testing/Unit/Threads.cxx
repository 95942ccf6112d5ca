// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
// A program ends only when VTK has joined the threads of its pool. A thread that is not waiting for
// work yet may miss that it should end, and then wait forever (an error of VTK 9.7,
// vtkSMPThreadPool). Tests that take milliseconds therefore give the threads time before they end.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace
{
class Threads : public testing::Environment
{
public:
  void TearDown() override { std::this_thread::sleep_for(std::chrono::milliseconds(100)); }
};

[[maybe_unused]] const testing::Environment* const Registered =
  testing::AddGlobalTestEnvironment(new Threads);
}

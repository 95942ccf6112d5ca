// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTuning.h"
#include "vtkShadowTuning.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
template <typename Tuning>
class TuningByName : public ::testing::Test
{
};
using Tunings = ::testing::Types<vtkNBufferTuning, vtkShadowTuning>;
TYPED_TEST_SUITE(TuningByName, Tunings);

// Hazard: a constant is printed, compared or checked, but cannot be set by its name, or the other
// way round.
TYPED_TEST(TuningByName, EveryConstantIsReadSetComparedAndPrinted)
{
  const TypeParam defaults;
  std::ostringstream text;
  defaults.PrintSelf(text, vtkIndent());
  for (const std::string& name : TypeParam::GetNames())
  {
    TypeParam tuning;
    const int value = tuning.Get(name);
    const int other = value == 1 ? 0 : 1;
    EXPECT_NE(text.str().find(name + ": " + std::to_string(value) + "\n"), std::string::npos)
      << name;
    EXPECT_TRUE(tuning.Set(name, other)) << name;
    EXPECT_EQ(tuning.Get(name), other) << name;
    EXPECT_FALSE(tuning == defaults) << name;
    EXPECT_TRUE(tuning.Set(name, value)) << name;
    EXPECT_TRUE(tuning == defaults) << name;
  }
}

TYPED_TEST(TuningByName, UnknownNamesChangeNothing)
{
  TypeParam tuning;
  for (const char* name : { "", "basefactor", "LitmapSource", "BaseFactor " })
  {
    EXPECT_EQ(tuning.Get(name), -1) << name;
    EXPECT_FALSE(tuning.Set(name, 1)) << name;
  }
  EXPECT_TRUE(tuning == TypeParam());
}

TEST(TuningByNameOfSwitches, OnlyZeroAndOneAreAccepted)
{
  vtkNBufferTuning tuning;
  EXPECT_FALSE(tuning.Set("BackOff", 2));
  EXPECT_FALSE(tuning.Set("BackOff", -1));
  EXPECT_TRUE(tuning.BackOff);
  EXPECT_TRUE(tuning.Set("BackOff", 0));
  EXPECT_FALSE(tuning.BackOff);
}

// A number out of its range can be set, and FindFault() names it.
TEST(TuningByNameOfNumbers, FindFaultNamesWhatIsOutOfRange)
{
  vtkNBufferTuning tuning;
  EXPECT_TRUE(tuning.Set("RoundSize", 0));
  EXPECT_EQ(tuning.FindFault(), "RoundSize must be 1 to 2147483647, not 0");
}
}

// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegressionTest.h
 * @brief Compares the picture of a window with a baseline, as vtkRegressionTestImage() does.
 *
 * VTK's own vtkTesting compares where this VTK has the module TestingRendering. VTK's wheels do not
 * have it. There ImageComparison.h compares, which is stricter; the arguments mean the same.
 */
#ifndef RegressionTest_h
#define RegressionTest_h

class vtkRenderWindow;

///@{
/// Two of the results of vtkTesting. The result 1 means that picture and baseline are alike.
constexpr int RegressionTestFailed = 0;
constexpr int RegressionTestIsInteractive = 3;
///@}

/// Compares and returns the result. In the arguments of the program, -V names the baseline, and -T
/// the folder for the picture. With -I nothing is compared.
int RunRegressionTest(int argc, char* argv[], vtkRenderWindow* window);

#endif

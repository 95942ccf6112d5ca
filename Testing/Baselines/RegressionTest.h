// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegressionTest.h
 * @brief What a window shows against the baseline that -V names, as vtkRegressionTestImage() does.
 *
 * It is VTK's own vtkTesting where this VTK has the module TestingRendering. Wheels have not; there
 * ImageComparison.h compares, which is stricter, and the arguments mean the same.
 */
#ifndef RegressionTest_h
#define RegressionTest_h

class vtkRenderWindow;

///@{
/// The results of vtkTesting.
constexpr int RegressionTestFailed = 0;
constexpr int RegressionTestIsInteractive = 3;
///@}

/// `-V` names the baseline, `-T` the folder for what was drawn and, on failure, for the difference.
/// With `-I` nothing is compared.
int RunRegressionTest(int argc, char* argv[], vtkRenderWindow* window);

#endif

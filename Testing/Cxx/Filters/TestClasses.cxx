// SPDX-License-Identifier: GPL-3.0-or-later
// The function that VTK's test driver calls, in VTK's own build: all tests of the classes.
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkStringOutputWindow.h>

#include <gtest/gtest.h>

int TestClasses(int argc, char* argv[])
{
  // VTK's build takes a printed error for a failure: tests provoke errors, and check them.
  vtkNew<vtkStringOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}

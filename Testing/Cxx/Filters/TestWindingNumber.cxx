// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkImplicitWindingNumber.h"
#include "vtkProbeWindingNumber.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace
{
/** A box of quadrilaterals over [0, 1] cubed, normals outward; without its lid if it is open. */
vtkSmartPointer<vtkPolyData> Box(bool open)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
  }
  const vtkIdType quads[6][4] = { { 0, 2, 3, 1 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
    { 1, 3, 7, 5 }, { 4, 5, 7, 6 } };
  for (int i = 0; i < (open ? 5 : 6); ++i)
  {
    polygons->InsertNextCell(4, quads[i]);
  }
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  return surface;
}

vtkSmartPointer<vtkImageData> Image()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(12, 12, 12);
  image->SetOrigin(-0.31, -0.32, -0.33);
  image->SetSpacing(0.151, 0.152, 0.153);
  return image;
}

TEST(vtkImplicitWindingNumber, CanBeAskedByManyThreadsFromTheFirstCallOn)
{
  const auto image = Image();
  vtkNew<vtkImplicitWindingNumber> reference;
  reference->SetInput(Box(true));
  std::vector<double> expected;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    expected.push_back(reference->EvaluateFunction(x));
  }
  for (int round = 0; round < 10; ++round)
  {
    vtkNew<vtkImplicitWindingNumber> shared;
    shared->SetInput(Box(true));
    const int numberOfThreads = 8;
    std::vector<std::vector<double>> values(numberOfThreads);
    std::vector<std::thread> threads;
    for (std::vector<double>& mine : values)
    {
      threads.emplace_back(
        [&]()
        {
          for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
          {
            double x[3];
            double g[3];
            image->GetPoint(i, x);
            mine.push_back(shared->EvaluateFunction(x));
            shared->EvaluateGradient(x, g);
          }
        });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    for (const std::vector<double>& mine : values)
    {
      EXPECT_EQ(mine, expected);
    }
  }
}

TEST(vtkProbeWindingNumber, CanBeStoppedAndRunAgain)
{
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(Image());
  probe->SetSurfaceData(Box(true));
  vtkNew<vtkCallbackCommand> stop;
  int calls = 0;
  stop->SetClientData(&calls);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* seen, void*)
    {
      ++*static_cast<int*>(seen);
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    });
  const unsigned long tag = probe->AddObserver(vtkCommand::ProgressEvent, stop);
  probe->Update();
  EXPECT_GT(calls, 0);
  EXPECT_EQ(probe->GetOutput()->GetPointData()->GetArray("w"), nullptr);
  EXPECT_EQ(probe->IsInsideSurface(0.5, 0.5, 0.5), 0);
  probe->RemoveObserver(tag);
  probe->SetAbortExecute(0);
  probe->Modified();
  probe->Update();
  ASSERT_NE(probe->GetOutput()->GetPointData()->GetArray("w"), nullptr);
  EXPECT_EQ(probe->IsInsideSurface(0.5, 0.5, 0.4), 1);
}

TEST(vtkProbeWindingNumber, TakesMoreThanAMillionPlacesPartByPart)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(103, 103, 103);
  image->SetOrigin(-0.31, -0.32, -0.33);
  image->SetSpacing(0.0161, 0.0162, 0.0163);
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(image);
  probe->SetSurfaceData(Box(true));
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> note;
  note->SetClientData(&progress);
  note->SetCallback(
    [](vtkObject* caller, unsigned long, void* seen, void*)
    {
      static_cast<std::vector<double>*>(seen)->push_back(
        static_cast<vtkAlgorithm*>(caller)->GetProgress());
    });
  probe->AddObserver(vtkCommand::ProgressEvent, note);
  for (const int association : { vtkProbeWindingNumber::POINTS, vtkProbeWindingNumber::CELLS })
  {
    progress.clear();
    probe->SetAssociation(association);
    probe->Update();
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
    vtkDataSet* const output = probe->GetOutput();
    const bool atPoints = association == vtkProbeWindingNumber::POINTS;
    const vtkIdType size = atPoints ? output->GetNumberOfPoints() : output->GetNumberOfCells();
    ASSERT_NE(output->GetAttributes(association)->GetArray("w"), nullptr);
    ASSERT_EQ(output->GetAttributes(association)->GetArray("w")->GetNumberOfTuples(), size);
    vtkIdType inside = 0;
    for (vtkIdType i = 0; i < size; i += 997)
    {
      double x[3];
      if (atPoints)
      {
        output->GetPoint(i, x);
      }
      else
      {
        double bounds[6];
        output->GetCellBounds(i, bounds);
        for (int axis = 0; axis < 3; ++axis)
        {
          x[axis] = (bounds[2 * axis] + bounds[2 * axis + 1]) / 2;
        }
      }
      EXPECT_EQ(probe->IsInside(i), probe->IsInsideSurface(x)) << i;
      inside += probe->IsInside(i);
    }
    EXPECT_GT(inside, 100);
  }
}

TEST(vtkProbeWindingNumber, IsExactOnAnOpenBox)
{
  // From the middle, each of the five sides fills a sixth of the view.
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, 0.5, 0.5);
  points->InsertNextPoint(0.5, 0.5, std::nan(""));
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(cloud);
  probe->SetSurfaceData(Box(true));
  probe->Update();
  vtkDataArray* w = probe->GetOutput()->GetPointData()->GetArray("w");
  EXPECT_NEAR(w->GetComponent(0, 0), 5.0 / 6, 1e-15);
  EXPECT_EQ(probe->IsInside(0), 1);
  EXPECT_TRUE(std::isnan(w->GetComponent(1, 0)));
  EXPECT_EQ(probe->IsInside(1), 0);
  probe->SetThreshold(0.9);
  probe->Update();
  EXPECT_EQ(probe->IsInside(0), 0);
}
} // namespace

// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/AllowedThreads.h"
#include "vtkImplicitWindingNumber.h"
#include "vtkSurfaceDefects.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <string>

#include <dlfcn.h>
#include <pthread.h>

namespace
{
std::atomic<int> ThreadsMade{ 0 };
} // namespace

/** Stands before the C library's, which does the work, and counts. */
extern "C" int pthread_create(
  pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*), void* argument)
{
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const Create own = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  ++ThreadsMade;
  return own(thread, attributes, start, argument);
}

namespace
{
/** Hills of 20,000 triangles: work enough for several threads. */
vtkSmartPointer<vtkPolyData> Terrain()
{
  constexpr int size = 101;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      points->InsertNextPoint(x, y, std::sin(x) * std::sin(y));
      const vtkIdType corner = y * size + x;
      if (x + 1 < size && y + 1 < size)
      {
        triangles->InsertNextCell({ corner, corner + 1, corner + size });
        triangles->InsertNextCell({ corner + 1, corner + size + 1, corner + size });
      }
    }
  }
  auto terrain = vtkSmartPointer<vtkPolyData>::New();
  terrain->SetPoints(points);
  terrain->SetPolys(triangles);
  return terrain;
}

/** How many threads a check of a surface makes that is worth several. */
int ThreadsOfFilter()
{
  vtkNew<vtkSurfaceDefects> defects;
  defects->SetInputData(Terrain());
  const int before = ThreadsMade;
  defects->Update();
  return ThreadsMade - before;
}

/** The same of a function that no filter runs. */
int ThreadsOfFunction()
{
  vtkNew<vtkImplicitWindingNumber> inside;
  inside->SetInput(Terrain());
  vtkNew<vtkPoints> places;
  for (int i = 0; i < 20000; ++i)
  {
    places->InsertNextPoint(i / 200.0, 30, 2);
  }
  vtkNew<vtkDoubleArray> values;
  const int before = ThreadsMade;
  inside->FunctionValue(places->GetData(), values);
  return ThreadsMade - before;
}

class ThreadLimits : public testing::Test
{
protected:
  ~ThreadLimits() override
  {
    unsetenv("VTK_SMP_MAX_THREADS");
    vtkSMPTools::Initialize(0);
    vtkSMPTools::SetBackend(this->Backend.c_str());
  }

  const testthreads::Allowed Four{ 4 };
  const std::string Backend = vtkSMPTools::GetBackend();
};
} // namespace

TEST_F(ThreadLimits, OfNobodyLeaveSeveralThreads)
{
  EXPECT_GT(ThreadsOfFilter(), 0);
  EXPECT_GT(ThreadsOfFunction(), 0);
}

TEST_F(ThreadLimits, ThatVtkWasToldHold)
{
  vtkSMPTools::Initialize(1);
  EXPECT_EQ(ThreadsOfFilter(), 0);
  EXPECT_EQ(ThreadsOfFunction(), 0);
}

TEST_F(ThreadLimits, OfALocalScopeHoldWithinIt)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(1), [] { EXPECT_EQ(ThreadsOfFilter(), 0); });
  EXPECT_GT(ThreadsOfFilter(), 0);
}

TEST_F(ThreadLimits, OfTheEnvironmentHold)
{
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  EXPECT_EQ(ThreadsOfFilter(), 0);
  vtkSMPTools::Initialize(3);
  EXPECT_EQ(ThreadsOfFilter(), 0);
}

TEST_F(ThreadLimits, OfASequentialBackendAreNone)
{
  vtkSMPTools::SetBackend("Sequential");
  EXPECT_GT(ThreadsOfFilter(), 0);
}

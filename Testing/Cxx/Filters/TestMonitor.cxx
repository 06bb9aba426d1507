// SPDX-License-Identifier: GPL-3.0-or-later
#include "Run/AlgorithmMonitor.h"

#include "Common/Stages.h"
#include "vtkConstrainedDelaunay3D.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkProbeWindingNumber.h"
#include "vtkRefineTetrahedra.h"
#include "vtkResolveSelfIntersections.h"
#include "vtkRobustTetrahedralize.h"
#include "vtkSolidQuality.h"
#include "vtkSurfaceDefects.h"
#include "vtkSurfaceReader.h"
#include "vtkSurfaceWriter.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataAlgorithm.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <unistd.h>

namespace Stages = insideout::Stages;

namespace
{
/** What an algorithm tells while it works. */
class Listener
{
public:
  explicit Listener(vtkAlgorithm* algorithm)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject* caller, unsigned long event, void* self, void* text)
      {
        auto* listener = static_cast<Listener*>(self);
        auto* told = static_cast<vtkAlgorithm*>(caller);
        if (event != vtkCommand::ProgressEvent)
        {
          listener->Warnings.push_back(static_cast<const char*>(text));
        }
        else if (told->GetProgressText())
        {
          listener->Seen.insert(told->GetProgressText());
          listener->Progress.push_back(told->GetProgress());
        }
      });
    for (const auto event :
      { vtkCommand::ProgressEvent, vtkCommand::WarningEvent, vtkCommand::ErrorEvent })
    {
      algorithm->AddObserver(event, this->Command);
    }
  }

  std::vector<std::string> Warnings; ///< and errors
  std::vector<double> Progress;
  std::set<std::string> Seen; ///< stages

private:
  vtkNew<vtkCallbackCommand> Command;
};

/** A box of quadrilaterals, normals outward. */
vtkSmartPointer<vtkPolyData> Box()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& quad : std::vector<std::vector<vtkIdType>>{ { 0, 2, 3, 1 }, { 0, 1, 5, 4 },
         { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 4, 5, 7, 6 } })
  {
    polygons->InsertNextCell(4, quad.data());
  }
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(polygons);
  return box;
}

/** Run a filter and expect it to say nothing but that it goes through these stages. */
void ExpectStages(vtkAlgorithm* filter, const std::set<std::string>& stages)
{
  Listener listener(filter);
  filter->Update();
  EXPECT_EQ(listener.Seen, stages) << filter->GetClassName();
  EXPECT_TRUE(std::is_sorted(listener.Progress.begin(), listener.Progress.end()))
    << filter->GetClassName();
  EXPECT_TRUE(listener.Warnings.empty())
    << filter->GetClassName() << ": " << listener.Warnings.front();
}
} // namespace

TEST(AlgorithmMonitor, WarnsOnceOfAStageThatItDoesNotKnowAndGoesOn)
{
  vtkNew<vtkPolyDataAlgorithm> algorithm;
  Listener listener(algorithm);
  vtkInsideOut::AlgorithmMonitor monitor(algorithm, { Stages::Validating, Stages::Segmenting });
  EXPECT_TRUE(monitor.Continue(Stages::Validating, 0.5));
  EXPECT_TRUE(listener.Warnings.empty());
  EXPECT_TRUE(monitor.Continue(Stages::Extracting, 0.2));
  EXPECT_TRUE(monitor.Continue(Stages::Extracting, 0.4));
  ASSERT_EQ(listener.Warnings.size(), 1u);
  EXPECT_NE(listener.Warnings[0].find("\"extracting\""), std::string::npos);
  EXPECT_TRUE(monitor.Continue(Stages::Segmenting, 0.5));
  EXPECT_EQ(listener.Warnings.size(), 1u);
  EXPECT_EQ(algorithm->GetProgress(), 0.75);
}

TEST(AlgorithmMonitor, TakesAStageThatComesAgainForAPartOfTheLaterOne)
{
  vtkNew<vtkPolyDataAlgorithm> algorithm;
  Listener listener(algorithm);
  vtkInsideOut::AlgorithmMonitor monitor(
    algorithm, { Stages::FindingIntersections, Stages::Resolving });
  monitor.Continue(Stages::FindingIntersections, 1);
  monitor.Continue(Stages::Resolving, 0.25);
  monitor.Continue(Stages::FindingIntersections, 0.5);
  EXPECT_STREQ(algorithm->GetProgressText(), Stages::Resolving);
  monitor.Continue(Stages::Resolving, 0.25);
  EXPECT_EQ(listener.Progress, (std::vector<double>{ 0.5, 0.625, 0.75 }));
  EXPECT_TRUE(listener.Warnings.empty());
}

TEST(AlgorithmMonitor, KnowsEveryStageThatTheFiltersRun)
{
  const std::set<std::string> toCrossings = { Stages::Validating, Stages::FindingIntersections };
  const auto with = [](std::set<std::string> stages, std::initializer_list<const char*> more)
  {
    stages.insert(more.begin(), more.end());
    return stages;
  };
  const auto box = Box();
  vtkNew<vtkResolveSelfIntersections> resolve;
  resolve->SetInputData(box);
  ExpectStages(resolve, with(toCrossings, { Stages::Resolving }));
  vtkNew<vtkSurfaceDefects> defects;
  defects->SetInputData(box);
  ExpectStages(defects,
    with(toCrossings,
      { Stages::Orienting, Stages::Resolving, Stages::WindingNumbers,
        Stages::TracingIntersections }));
  vtkNew<vtkConstrainedDelaunay3D> delaunay;
  delaunay->SetInputData(box);
  ExpectStages(delaunay, with(toCrossings, { Stages::Tetrahedralizing }));
  vtkNew<vtkGeneralizedWindingNumber> windingNumber;
  windingNumber->SetInputData(box);
  const std::set<std::string> toWindingNumbers = with(toCrossings,
    { Stages::Orienting, Stages::Resolving, Stages::Tetrahedralizing, Stages::WindingNumbers });
  ExpectStages(windingNumber, toWindingNumbers);
  vtkNew<vtkGraphCutSegmentation> cut;
  cut->SetInputConnection(windingNumber->GetOutputPort());
  ExpectStages(cut, { Stages::Segmenting });
  vtkNew<vtkSolidQuality> quality;
  quality->SetInputConnection(windingNumber->GetOutputPort());
  ExpectStages(quality, with(toCrossings, { Stages::Measuring }));
  vtkNew<vtkRobustTetrahedralize> robust;
  robust->SetInputData(box);
  robust->ConstrainFacetsOn();
  robust->SetNonManifold(vtkGraphCutSegmentation::NONMANIFOLD_FILL);
  robust->MergeCoplanarPiecesOn();
  robust->SplitSeamsOn();
  ExpectStages(robust, with(toWindingNumbers, { Stages::Segmenting, Stages::Extracting }));
  vtkNew<vtkRefineTetrahedra> refine;
  refine->SetInputConnection(robust->GetOutputPort());
  ExpectStages(refine, { Stages::Refining });
  robust->RefineOn();
  ExpectStages(robust, { Stages::Segmenting, Stages::Extracting, Stages::Refining }); // of its hull
  vtkNew<vtkProbeWindingNumber> probe;
  probe->SetInputData(box);
  probe->SetSurfaceData(box);
  ExpectStages(probe, { Stages::Validating, Stages::Orienting, Stages::WindingNumbers });

  const std::string file =
    testing::TempDir() + "insideout-stages-" + std::to_string(getpid()) + ".ply";
  vtkNew<vtkSurfaceWriter> writer;
  writer->SetInputData(box);
  writer->SetFileName(file.c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkSurfaceReader> reader;
  reader->SetFileName(file.c_str());
  ExpectStages(reader, { Stages::Reading });
  unlink(file.c_str());
}

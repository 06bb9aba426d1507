// SPDX-License-Identifier: GPL-3.0-or-later
#include "ForPython/UpdateAlgorithm.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <exception>

namespace
{
/** Reports the events of an algorithm and its executive to the listener during its lifetime. */
class Observation : public vtkCommand
{
public:
  static Observation* New() { return new Observation; }

  void Begin(vtkAlgorithm* algorithm, vtkInsideOutListener listener)
  {
    this->Algorithm = algorithm;
    this->Listener = listener;
    algorithm->AddObserver(vtkCommand::ProgressEvent, this);
    algorithm->AddObserver(vtkCommand::WarningEvent, this);
    algorithm->AddObserver(vtkCommand::ErrorEvent, this);
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this);
  }

  /** @return whether there was no error */
  bool End()
  {
    this->Algorithm->RemoveObserver(this);
    this->Algorithm->GetExecutive()->RemoveObserver(this);
    return !this->Failed;
  }

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    if (event == vtkCommand::ProgressEvent)
    {
      const char* doing = this->Algorithm->GetProgressText();
      this->Tell(VTK_INSIDEOUT_PROGRESS, doing ? doing : "", this->Algorithm->GetProgress());
    }
    else
    {
      const auto kind = caller != this->Algorithm ? VTK_INSIDEOUT_REQUEST_FAILED
        : event == vtkCommand::ErrorEvent         ? VTK_INSIDEOUT_ERROR
                                                  : VTK_INSIDEOUT_WARNING;
      this->Tell(kind, static_cast<const char*>(data), 0);
    }
  }

  void Tell(vtkInsideOutEvent event, const char* text, double fraction)
  {
    this->Failed =
      this->Failed || event == VTK_INSIDEOUT_ERROR || event == VTK_INSIDEOUT_REQUEST_FAILED;
    if (this->Listener(event, text, fraction) != 0)
    {
      this->Algorithm->SetAbortExecute(1);
    }
  }

private:
  vtkAlgorithm* Algorithm = nullptr;
  vtkInsideOutListener Listener = nullptr;
  bool Failed = false;
};
} // namespace

extern "C" int vtkInsideOutUpdate(void* object, int wholeExtent, vtkInsideOutListener listener)
{
  auto* algorithm = static_cast<vtkAlgorithm*>(static_cast<vtkObjectBase*>(object));
  vtkNew<Observation> observation;
  observation->Begin(algorithm, listener);
  try
  {
    wholeExtent ? static_cast<void>(algorithm->UpdateWholeExtent())
                : static_cast<void>(algorithm->Update());
  }
  catch (const std::bad_alloc&)
  {
    observation->Tell(VTK_INSIDEOUT_ERROR, "not enough memory", 0);
  }
  catch (const std::exception& error)
  {
    observation->Tell(VTK_INSIDEOUT_ERROR, error.what(), 0);
  }
  return observation->End() ? 1 : 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "InsideOutAbortButton.h"

#include "ButtonPress.h"

#include <pqApplicationCore.h>
#include <pqCoreUtilities.h>
#include <pqPipelineSource.h>
#include <pqProgressManager.h>
#include <pqProgressWidget.h>
#include <pqPropertiesPanel.h>
#include <pqServerManagerModel.h>
#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkOutputWindow.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProxy.h>

#include <QMainWindow>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace
{
constexpr char Hint[] = "AbortsPromptly"; ///< of the proxies whose filters ask often enough

vtkAlgorithm* AlgorithmOf(pqPipelineSource* source)
{
  return vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject());
}

QList<pqPipelineSource*> AllSources()
{
  return pqApplicationCore::instance()->getServerManagerModel()->findItems<pqPipelineSource*>();
}

pqPipelineSource* SourceOf(vtkObject* algorithm)
{
  const auto sources = AllSources();
  const auto found = std::find_if(sources.begin(), sources.end(),
    [&](pqPipelineSource* source) { return AlgorithmOf(source) == algorithm; });
  return found == sources.end() ? nullptr : *found;
}

/** Show a message in the status bar; an empty one clears it. */
void ShowMessage(const QString& message)
{
  if (auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget()))
  {
    window->statusBar()->showMessage(message);
  }
}
} // namespace

InsideOutAbortButton::InsideOutAbortButton(QObject* parent)
  : QObject(parent)
{
}

void InsideOutAbortButton::startup()
{
  pqApplicationCore* core = pqApplicationCore::instance();
  this->Manager = core->getProgressManager();
  connect(this->Manager, &pqProgressManager::abort, this, &InsideOutAbortButton::abort);
  connect(core->getServerManagerModel(), &pqServerManagerModel::sourceAdded, this,
    &InsideOutAbortButton::watch);
  connect(core->getServerManagerModel(), &pqServerManagerModel::sourceRemoved, this,
    &InsideOutAbortButton::forget);
  for (pqPipelineSource* source : AllSources())
  {
    this->watch(source);
  }
}

void InsideOutAbortButton::shutdown() {}

void InsideOutAbortButton::watch(pqPipelineSource* source)
{
  vtkPVXMLElement* hints = source->getProxy()->GetHints();
  vtkAlgorithm* algorithm = AlgorithmOf(source);
  if (CanTellPress() && algorithm && hints && hints->FindNestedElementByName(Hint))
  {
    pqCoreUtilities::connect(algorithm, vtkCommand::StartEvent, this, SLOT(begin(vtkObject*)));
    pqCoreUtilities::connect(
      algorithm, vtkCommand::ProgressEvent, this, SLOT(lookForPress(vtkObject*)));
    pqCoreUtilities::connect(algorithm, vtkCommand::EndEvent, this, SLOT(end(vtkObject*)));
  }
}

void InsideOutAbortButton::forget(pqPipelineSource* source)
{
  this->Stopped.remove(source);
}

void InsideOutAbortButton::begin(vtkObject* algorithm)
{
  const auto stopped = this->Stopped.find(SourceOf(algorithm));
  if (stopped != this->Stopped.end() && algorithm->GetMTime() != stopped.value())
  {
    vtkAlgorithm::SafeDownCast(algorithm)->SetAbortExecute(0);
    this->Stopped.erase(stopped);
    ShowMessage("");
  }
}

void InsideOutAbortButton::lookForPress(vtkObject* algorithm)
{
  if (!this->Button)
  {
    QWidget* window = pqCoreUtilities::mainWidget();
    auto* bar = window ? window->findChild<pqProgressWidget*>() : nullptr;
    this->Button = bar ? bar->abortButton() : nullptr;
  }
  if (!this->Button)
  {
    return;
  }
  this->Working = vtkAlgorithm::SafeDownCast(algorithm);
  if (!this->Button->isEnabled())
  {
    this->Manager->setEnableAbort(true);
    this->Button->repaint();
  }
  if (IsPressWaiting(this->Button))
  {
    this->Manager->triggerAbort();
  }
}

void InsideOutAbortButton::abort()
{
  if (this->Working)
  {
    this->Working->SetAbortExecute(1);
  }
}

void InsideOutAbortButton::end(vtkObject* algorithm)
{
  this->Working = nullptr;
  this->Manager->setEnableAbort(false);
  pqPipelineSource* source = SourceOf(algorithm);
  if (!source || !AlgorithmOf(source)->GetAbortExecute())
  {
    return;
  }
  const bool isNews = !this->Stopped.contains(source);
  this->Stopped.insert(source, algorithm->GetMTime());
  if (isNews)
  {
    const QString message =
      source->getSMName() + " was stopped and has no output. Apply runs it again.";
    ShowMessage(message);
    vtkOutputWindowDisplayText((message + "\n").toUtf8().data());
    // ParaView marks the source as applied once this run is over.
    QTimer::singleShot(0, this, &InsideOutAbortButton::offerToApply);
  }
}

void InsideOutAbortButton::offerToApply()
{
  for (pqPipelineSource* source : this->Stopped.keys())
  {
    source->setModifiedState(pqProxy::MODIFIED);
  }
  for (auto* panel : pqCoreUtilities::mainWidget()->findChildren<pqPropertiesPanel*>())
  {
    connect(panel, QOverload<pqProxy*>::of(&pqPropertiesPanel::applied), this,
      &InsideOutAbortButton::apply, Qt::UniqueConnection);
    connect(panel, &pqPropertiesPanel::resetDone, this, &InsideOutAbortButton::offerToApply,
      Qt::UniqueConnection);
  }
}

void InsideOutAbortButton::apply(pqProxy* proxy)
{
  auto* source = qobject_cast<pqPipelineSource*>(proxy);
  if (this->Stopped.contains(source))
  {
    AlgorithmOf(source)->Modified();
    source->getProxy()->MarkModified(source->getProxy());
  }
}

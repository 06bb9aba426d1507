// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   InsideOutAbortButton
 * @brief   Makes the abort button beside ParaView's progress bar stop the plugin's filters.
 *
 * ParaView 5.11 shows that button, but never enables it, and looks at no event while a filter works
 * (pqProgressManager::setProgress). Events must not be handled then either: whatever draws or
 * changes the pipeline would run the filter within itself. So at each report of progress this
 * looks into the window system's queue for a press of the button, and leaves everything there.
 * Takes a display of X11 and ParaView's builtin server; elsewhere the button stays disabled.
 *
 * A filter that was stopped has no output. Its source is then modified again, so that Apply runs
 * it.
 */
#ifndef InsideOutAbortButton_h
#define InsideOutAbortButton_h

#include <vtkType.h>

#include <QHash>
#include <QObject>
#include <QPointer>

class pqPipelineSource;
class pqProgressManager;
class pqProxy;
class QToolButton;
VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkObject;
VTK_ABI_NAMESPACE_END

class InsideOutAbortButton : public QObject
{
  Q_OBJECT

public:
  explicit InsideOutAbortButton(QObject* parent = nullptr);

  void startup(); ///< what ParaView calls once the plugin is loaded
  void shutdown();

private Q_SLOTS:
  void watch(pqPipelineSource* source);
  void forget(pqPipelineSource* source);
  void begin(vtkObject* algorithm);
  void lookForPress(vtkObject* algorithm);
  void abort();
  void end(vtkObject* algorithm);
  void offerToApply();
  void apply(pqProxy* proxy);

private:
  pqProgressManager* Manager = nullptr;
  QPointer<QToolButton> Button;
  vtkAlgorithm* Working = nullptr;
  QHash<pqPipelineSource*, vtkMTimeType> Stopped; ///< and when their filters were last modified
};

#endif

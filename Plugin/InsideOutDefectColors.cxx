// SPDX-License-Identifier: GPL-3.0-or-later
#include "InsideOutDefectColors.h"

#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqServerManagerModel.h>
#include <pqView.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMTrace.h>

#include <string>

namespace
{
void ShowAsIs(pqDataRepresentation* representation)
{
  vtkSMProxy* proxy = representation->getProxy();
  const char* array = vtkSMPropertyHelper(proxy, "ColorArrayName").GetInputArrayNameToProcess();
  if (!representation->getView() || !array || array != std::string("DefectColor"))
  {
    return;
  }
  vtkSMPVRepresentationProxy::SetScalarBarVisibility(
    proxy, representation->getView()->getProxy(), false);
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", proxy);
  vtkSMRepresentationProxy::SetRepresentationType(proxy, "Defect Colors");
  representation->renderViewEventually();
}
} // namespace

InsideOutDefectColors::InsideOutDefectColors(QObject* parent)
  : QObject(parent)
{
}

void InsideOutDefectColors::startup()
{
  connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::representationAdded, this, &InsideOutDefectColors::watch);
}

void InsideOutDefectColors::shutdown() {}

void InsideOutDefectColors::watch(pqRepresentation* representation)
{
  auto* shown = qobject_cast<pqDataRepresentation*>(representation);
  if (shown && shown->getProxy()->GetXMLName() == std::string("SurfaceDefectsRepresentation"))
  {
    // Queued: after ParaView has shown the legend.
    connect(
      shown, &pqDataRepresentation::colorArrayNameModified, this, [shown] { ShowAsIs(shown); },
      Qt::QueuedConnection);
  }
}

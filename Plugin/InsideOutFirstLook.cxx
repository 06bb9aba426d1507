// SPDX-License-Identifier: GPL-3.0-or-later
#include "InsideOutFirstLook.h"

#include <pqActiveObjects.h>
#include <pqApplicationCore.h>
#include <pqDataRepresentation.h>
#include <pqObjectBuilder.h>
#include <pqOutputPort.h>
#include <pqPipelineFilter.h>
#include <pqPipelineSource.h>
#include <pqRenderView.h>
#include <vtkCamera.h>
#include <vtkDataObject.h>
#include <vtkNew.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPVRepresentationProxy.h>
#include <vtkSMParaViewPipelineControllerWithRendering.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMRenderViewProxy.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSettings.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMTrace.h>
#include <vtkSMTransferFunctionManager.h>
#include <vtkSMViewProxy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace
{
constexpr char LookHint[] = "FirstLook";
constexpr char ColorsHint[] = "WindingNumberColors";
constexpr char CameraHint[] = "FacesCamera";
constexpr char HullHint[] = "TakesHull";
constexpr char WindingNumber[] = "w";
constexpr char WithEdges[] = "Surface With Edges";
constexpr vtkTypeInt64 MostCellsWithEdges = 50000;

/** Blue outside, white where w is 1/2, red inside, as in the pictures of the Python package. */
const std::vector<double> ColorsOfW = { //
  -1.0, 0.09, 0.17, 0.36,               //
  0.0, 0.38, 0.58, 0.80,                //
  0.5, 0.97, 0.97, 0.95,                //
  1.0, 0.85, 0.44, 0.32,                //
  2.0, 0.40, 0.02, 0.10
};
const std::vector<double> OpacitiesOfW = { -1.0, 0.0, 0.5, 0.0, 2.0, 1.0, 0.5, 0.0 };

void SetNumbers(vtkSMProxy* proxy, const char* property, const std::vector<double>& numbers)
{
  vtkSMPropertyHelper(proxy, property).Set(numbers.data(), static_cast<unsigned>(numbers.size()));
}

/** Whether there are colors of an array of this name, or the user keeps some for it. */
bool HasColors(vtkSMSessionProxyManager* session)
{
  const std::string name = WindingNumber;
  const auto isKept = [](const std::string& setting)
  { return vtkSMSettings::GetInstance()->HasSetting(setting.c_str()); };
  return session->GetProxy("lookup_tables", (name + ".PVLookupTable").c_str()) ||
    isKept(".array_lookup_tables." + name) || isKept(".standard_presets." + name);
}

void ColorWindingNumbers(vtkSMSessionProxyManager* session)
{
  if (HasColors(session))
  {
    return;
  }
  vtkNew<vtkSMTransferFunctionManager> functions;
  vtkSMProxy* opacities = functions->GetOpacityTransferFunction(WindingNumber, session);
  vtkSMProxy* colors = functions->GetColorTransferFunction(WindingNumber, session);
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", colors);
  SetNumbers(colors, "RGBPoints", ColorsOfW);
  vtkSMPropertyHelper(colors, "ColorSpace").Set("Lab");
  vtkSMPropertyHelper(colors, "AutomaticRescaleRangeMode").Set(vtkSMTransferFunctionManager::NEVER);
  vtkSMPropertyHelper(colors, "ScalarRangeInitialized").Set(1);
  SetNumbers(opacities, "Points", OpacitiesOfW);
  vtkSMPropertyHelper(opacities, "ScalarRangeInitialized").Set(1);
  colors->UpdateVTKObjects();
  opacities->UpdateVTKObjects();
}

/** Turn the plane's normal to the axis nearest to the viewing direction. */
void FaceCamera(vtkSMProxy* plane)
{
  auto* view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  if (view && plane && plane->GetProperty("Normal"))
  {
    std::array<double, 3> direction;
    view->getRenderViewProxy()->GetActiveCamera()->GetDirectionOfProjection(direction.data());
    const auto isShorter = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const auto longest = std::max_element(direction.begin(), direction.end(), isShorter);
    std::vector<double> normal(3, 0.0);
    normal[longest - direction.begin()] = 1;
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", plane);
    SetNumbers(plane, "Normal", normal);
    plane->UpdateVTKObjects();
  }
}

bool HasCells(pqOutputPort* port)
{
  return port->getDataInformation()->GetNumberOfCells() > 0;
}

/** Color by no array; without a color, by ParaView's default. */
void Paint(vtkSMProxy* representation, vtkSMProxy* view, const std::vector<double>& color)
{
  if (vtkSMPVRepresentationProxy::GetUsingScalarColoring(representation))
  {
    vtkSMProxy* unused = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
    vtkSMPVRepresentationProxy::SetScalarColoring(representation, nullptr, 0);
    vtkNew<vtkSMTransferFunctionManager>()->HideScalarBarIfNotNeeded(unused, view);
  }
  SM_SCOPED_TRACE(PropertiesModified).arg("proxy", representation);
  for (const char* part : { "AmbientColor", "DiffuseColor" })
  {
    if (!color.empty())
    {
      SetNumbers(representation, part, color);
    }
  }
  representation->UpdateVTKObjects();
}

/** The association of the array of this name; cells take precedence over points. */
int AssociationOf(pqOutputPort* port, const std::string& array)
{
  const auto isOf = [&](int association)
  { return port->getDataInformation()->GetArrayInformation(array.c_str(), association); };
  return isOf(vtkDataObject::CELL) ? vtkDataObject::CELL : vtkDataObject::POINT;
}

/** Color by an array, with a legend of its own instead of ParaView's. */
void ColorBy(pqOutputPort* port, vtkSMProxy* representation, vtkSMProxy* view, const char* array)
{
  using Representation = vtkSMPVRepresentationProxy;
  vtkSMProxy* unused = vtkSMPropertyHelper(representation, "LookupTable").GetAsProxy();
  Representation::SetScalarColoring(representation, array, AssociationOf(port, array));
  if (unused)
  {
    vtkNew<vtkSMTransferFunctionManager>()->HideScalarBarIfNotNeeded(unused, view);
  }
  Representation::RescaleTransferFunctionToDataRange(representation);
  Representation::SetScalarBarVisibility(representation, view, true);
}

/** The requested representation, without edges if they would cover the faces. */
std::string RepresentationOf(pqOutputPort* port, vtkPVXMLElement* hint)
{
  const std::string asked = hint->GetAttribute("representation");
  const bool isDense = port->getDataInformation()->GetNumberOfCells() > MostCellsWithEdges;
  return asked == WithEdges && isDense ? "Surface" : asked;
}

void LookAt(pqOutputPort* port, vtkPVXMLElement* hint)
{
  const std::string shown = hint->GetAttributeOrDefault("shown", "always");
  const bool isHidden = shown == "never" || (shown == "if_any" && !HasCells(port));
  std::vector<double> color(3);
  color.resize(hint->GetVectorAttribute("color", 3, color.data()));
  for (pqDataRepresentation* representation : port->getRepresentations(nullptr))
  {
    auto* view = qobject_cast<pqRenderView*>(representation->getView());
    if (view && hint->GetAttribute("color"))
    {
      Paint(representation->getProxy(), view->getProxy(), color);
    }
    if (view && hint->GetAttribute("representation"))
    {
      SM_SCOPED_TRACE(PropertiesModified).arg("proxy", representation->getProxy());
      vtkSMRepresentationProxy::SetRepresentationType(
        representation->getProxy(), RepresentationOf(port, hint).c_str());
    }
    if (view && hint->GetAttribute("by"))
    {
      ColorBy(port, representation->getProxy(), view->getProxy(), hint->GetAttribute("by"));
    }
    if (view && isHidden)
    {
      vtkNew<vtkSMParaViewPipelineControllerWithRendering>()->Hide(
        port->getSourceProxy(), port->getPortNumber(), view->getViewProxy());
    }
  }
}

bool HasHint(pqPipelineSource* source, const char* hint)
{
  vtkPVXMLElement* hints = source->getProxy()->GetHints();
  return hints && hints->FindNestedElementByName(hint);
}

/** Show or hide the output of a port in the active view, if it has been shown there. */
void SetVisible(pqOutputPort* port, bool visible)
{
  auto* view = qobject_cast<pqRenderView*>(pqActiveObjects::instance().activeView());
  if (view && port->getRepresentation(view))
  {
    vtkNew<vtkSMParaViewPipelineControllerWithRendering>()->SetVisibility(
      port->getSourceProxy(), port->getPortNumber(), view->getViewProxy(), visible);
  }
}

std::vector<pqOutputPort*> InputsOf(pqPipelineSource* source)
{
  auto* filter = qobject_cast<pqPipelineFilter*>(source);
  const QList<pqOutputPort*> inputs = filter ? filter->getInputs() : QList<pqOutputPort*>();
  return { inputs.begin(), inputs.end() };
}

/**
 * Hide the outputs of the plugin's other filters with the same inputs: they lie in the same place.
 */
void HideSiblings(pqPipelineSource* filter)
{
  for (pqOutputPort* input : InputsOf(filter))
  {
    for (pqPipelineSource* other : input->getConsumers())
    {
      const auto ports = other->getOutputPorts();
      for (pqOutputPort* port : ports)
      {
        if (other != filter && HasHint(other, LookHint))
        {
          SetVisible(port, false);
        }
      }
    }
  }
}

/** Show or hide the inputs of a filter. Its outputs stay visible, or Apply would not run it. */
void ShowInputs(pqPipelineSource* filter, bool visible)
{
  for (pqOutputPort* input : InputsOf(filter))
  {
    SetVisible(input, visible);
  }
  filter->renderAllViews();
}

/** Connect a filter to the hull of a solid, which is made for it, instead of the solid. */
void TakeHull(pqPipelineSource* source)
{
  auto* filter = qobject_cast<pqPipelineFilter*>(source);
  pqOutputPort* input = filter && filter->getInputCount() == 1 ? filter->getInputs()[0] : nullptr;
  pqPipelineSource* maker = input ? input->getSource() : nullptr;
  pqOutputPort* hull = maker ? maker->getOutputPort(QString("Hull")) : nullptr;
  if (!hull || input->getPortNumber() != 0)
  {
    return;
  }
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", maker->getProxy());
    vtkSMPropertyHelper(maker->getProxy(), "GenerateHull").Set(1);
    maker->getProxy()->UpdateVTKObjects();
  }
  // ParaView's own trace of a changed input names a property that a slice has not.
  const QString number = QString::number(hull->getPortNumber());
  const QString line = "FindSource('" + filter->getSMName() + "').Input = OutputPort(FindSource('" +
    maker->getSMName() + "'), " + number + ")";
  SM_SCOPED_TRACE(TraceText).arg(line.toUtf8().data());
  vtkSMPropertyHelper(filter->getProxy(), "Input")
    .Set(maker->getProxy(), static_cast<unsigned>(hull->getPortNumber()));
  filter->getProxy()->UpdateVTKObjects();
}

void Look(pqPipelineSource* filter)
{
  vtkPVXMLElement* hints = filter->getProxy()->GetHints();
  for (unsigned i = 0; i < hints->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(i);
    int port = 0;
    if (hint->GetName() == std::string(LookHint) && hint->GetScalarAttribute("port", &port))
    {
      LookAt(filter->getOutputPort(port), hint);
    }
  }
  HideSiblings(filter);
  filter->renderAllViews();
}

/** A filter that failed or was stopped has no result to show. */
bool HasResult(pqPipelineSource* filter)
{
  const auto ports = filter->getOutputPorts();
  return std::any_of(ports.begin(), ports.end(), HasCells);
}
} // namespace

InsideOutFirstLook::InsideOutFirstLook(QObject* parent)
  : QObject(parent)
{
}

void InsideOutFirstLook::startup()
{
  connect(pqApplicationCore::instance()->getObjectBuilder(), &pqObjectBuilder::filterCreated, this,
    &InsideOutFirstLook::prepare);
}

void InsideOutFirstLook::shutdown() {}

void InsideOutFirstLook::prepare(pqPipelineSource* filter)
{
  vtkPVXMLElement* hints = filter->getProxy()->GetHints();
  if (HasHint(filter, ColorsHint))
  {
    ColorWindingNumbers(filter->proxyManager());
  }
  if (vtkPVXMLElement* hint = hints ? hints->FindNestedElementByName(CameraHint) : nullptr)
  {
    FaceCamera(
      vtkSMPropertyHelper(filter->getProxy(), hint->GetAttributeOrEmpty("property")).GetAsProxy());
  }
  if (HasHint(filter, HullHint))
  {
    TakeHull(filter);
  }
  if (HasHint(filter, LookHint))
  {
    const auto isSeen = std::make_shared<bool>(false);
    const auto areInputsShown = std::make_shared<bool>(false); // again
    const auto look = [filter, isSeen, areInputsShown]
    {
      if (*isSeen || filter->modifiedState() == pqProxy::UNINITIALIZED)
      {
        return;
      }
      *isSeen = HasResult(filter);
      if (*isSeen == *areInputsShown)
      {
        *areInputsShown = !*isSeen;
        ShowInputs(filter, *areInputsShown);
      }
      if (*isSeen)
      {
        Look(filter);
      }
    };
    // ParaView calls a filter unmodified as soon as it shows its outputs, before it draws them.
    connect(filter, &pqProxy::modifiedStateChanged, filter, look);
    // If an output exists only after a later Apply, the others have been shown long ago, and may be
    // drawing.
    connect(filter, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), filter, look,
      Qt::QueuedConnection);
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "InsideOutSummary.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <QLabel>
#include <QVBoxLayout>

namespace
{
constexpr char Told[] = "Summary";
}

InsideOutSummary::InsideOutSummary(vtkSMProxy* proxy, vtkSMProperty*, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Text(new QLabel(this))
{
  this->setShowLabel(false);
  this->Text->setObjectName("Text");
  this->Text->setWordWrap(true);
  this->Text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Text);
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  if (auto* source = model->findItem<pqPipelineSource*>(proxy))
  {
    this->connect(source, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
      &InsideOutSummary::refresh);
  }
  this->refresh();
}

void InsideOutSummary::refresh()
{
  this->proxy()->UpdatePropertyInformation(this->proxy()->GetProperty(Told));
  this->Text->setText(vtkSMPropertyHelper(this->proxy(), Told).GetAsString());
  this->Text->setVisible(!this->Text->text().isEmpty());
}

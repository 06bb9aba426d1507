// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   InsideOutSummary
 * @brief   Shows in a filter's panel what its property Summary tells after Apply.
 *
 * ParaView's panels show no property that is information only.
 */
#ifndef InsideOutSummary_h
#define InsideOutSummary_h

#include <pqPropertyWidget.h>

class QLabel;

class InsideOutSummary : public pqPropertyWidget
{
  Q_OBJECT

public:
  InsideOutSummary(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);

private Q_SLOTS:
  void refresh();

private:
  QLabel* Text;
};

#endif

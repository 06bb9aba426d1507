// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   InsideOutDefectColors
 * @brief   Shows the array DefectColor as the colors that it has when it is chosen in Color By.
 *
 * ParaView would map their magnitude to other colors, with a legend that means nothing.
 */
#ifndef InsideOutDefectColors_h
#define InsideOutDefectColors_h

#include <QObject>

class pqRepresentation;

class InsideOutDefectColors : public QObject
{
  Q_OBJECT

public:
  explicit InsideOutDefectColors(QObject* parent = nullptr);

  void startup(); ///< what ParaView calls once the plugin is loaded
  void shutdown();

private Q_SLOTS:
  void watch(pqRepresentation* representation);
};

#endif

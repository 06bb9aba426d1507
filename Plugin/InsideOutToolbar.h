// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   InsideOutToolbar
 * @brief   Keeps the plugin's toolbar to the filters of the usual path.
 *
 * ParaView 5.11 makes the actions of a plugin's filters before it reads the plugin's menu
 * (vtkSIProxyDefinitionManager::AttachShowInMenuHintsToProxy), and heeds that menu's
 * omit_from_toolbar only for actions that it makes later.
 */
#ifndef InsideOutToolbar_h
#define InsideOutToolbar_h

#include <QObject>

class InsideOutToolbar : public QObject
{
  Q_OBJECT

public:
  explicit InsideOutToolbar(QObject* parent = nullptr);

  void startup(); ///< what ParaView calls once the plugin is loaded
  void shutdown();

private Q_SLOTS:
  void watchMenus();
  void trim();
};

#endif

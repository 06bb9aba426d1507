// SPDX-License-Identifier: GPL-3.0-or-later
#include "InsideOutToolbar.h"

#include <pqCoreUtilities.h>
#include <pqProxyGroupMenuManager.h>

#include <QAction>
#include <QStringList>
#include <QTimer>
#include <QToolBar>

InsideOutToolbar::InsideOutToolbar(QObject* parent)
  : QObject(parent)
{
}

void InsideOutToolbar::startup()
{
  // The window may still be in the making.
  QTimer::singleShot(0, this, &InsideOutToolbar::watchMenus);
}

void InsideOutToolbar::watchMenus()
{
  for (auto* menu : pqCoreUtilities::mainWidget()->findChildren<pqProxyGroupMenuManager*>())
  {
    // Queued: after ParaView has filled the toolbar.
    connect(menu, &pqProxyGroupMenuManager::menuPopulated, this, &InsideOutToolbar::trim,
      Qt::QueuedConnection);
  }
  this->trim();
}

void InsideOutToolbar::shutdown() {}

void InsideOutToolbar::trim()
{
  const QStringList usualPath{ "SurfaceDefects", "RobustTetrahedralize", "SliceWindingNumber" };
  auto* toolbar = pqCoreUtilities::mainWidget()->findChild<QToolBar*>("Inside Out");
  for (QAction* action : toolbar ? toolbar->actions() : QList<QAction*>())
  {
    if (!usualPath.contains(action->objectName()))
    {
      toolbar->removeAction(action);
    }
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef ButtonPress_h
#define ButtonPress_h

class QWidget;

/** Whether presses can be told on this display: it is one of X11. */
bool CanTellPress();

/**
 * Whether a press of the first mouse button on the widget waits in the window system's queue, and
 * stays there. Always false on a display other than X11.
 */
bool IsPressWaiting(const QWidget* widget);

#endif

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ButtonPress.h"

#include <QRect>
#include <QWidget>
#include <QX11Info>

#include <xcb/xcb.h>

#include <cstdlib>
#include <cstring>

namespace
{
/**
 * A press as libxcb delivers it if the server has version 2 of the X Input Extension (XI2proto.txt,
 * DeviceEvent); FullSequence follows the first 32 bytes.
 */
struct InputPress
{
  uint8_t ResponseType;
  uint8_t Extension;
  uint16_t Sequence;
  uint32_t Length;
  uint16_t EventType;
  uint16_t DeviceId;
  uint32_t Time;
  uint32_t Button;
  uint32_t Root;
  uint32_t Window;
  uint32_t Child;
  uint32_t FullSequence;
  int32_t RootX;
  int32_t RootY;
  int32_t X; ///< of the window, in 1/65536 of a pixel
  int32_t Y;
};
static_assert(sizeof(InputPress) == 52, "as it comes over the wire");

constexpr uint16_t InputButtonPress = 4;
constexpr uint32_t FirstButton = 1;

uint8_t InputExtension()
{
  constexpr char Name[] = "XInputExtension";
  xcb_connection_t* connection = QX11Info::connection();
  xcb_query_extension_reply_t* reply = xcb_query_extension_reply(
    connection, xcb_query_extension(connection, std::strlen(Name), Name), nullptr);
  const uint8_t opcode = reply && reply->present ? reply->major_opcode : 0;
  std::free(reply);
  return opcode;
}

/** The rectangle of a window in which presses count, in pixels. */
struct Place
{
  xcb_window_t Window;
  QRect Rectangle;
  uint8_t InputExtension;

  bool Has(uint32_t window, uint32_t button, int x, int y) const
  {
    return window == this->Window && button == FirstButton && this->Rectangle.contains(x, y);
  }
};

bool IsPressIn(xcb_generic_event_t* event, void* data)
{
  const auto* place = static_cast<const Place*>(data);
  constexpr uint8_t SentByAProgram = 0x80;
  const uint8_t type = event->response_type & ~SentByAProgram;
  if (type == XCB_BUTTON_PRESS)
  {
    const auto* press = reinterpret_cast<const xcb_button_press_event_t*>(event);
    return place->Has(press->event, press->detail, press->event_x, press->event_y);
  }
  if (type != XCB_GE_GENERIC)
  {
    return false;
  }
  const auto* press = reinterpret_cast<const InputPress*>(event);
  return press->Extension == place->InputExtension && press->EventType == InputButtonPress &&
    place->Has(press->Window, press->Button, press->X / 65536, press->Y / 65536);
}
} // namespace

bool CanTellPress()
{
  return QX11Info::isPlatformX11();
}

bool IsPressWaiting(const QWidget* widget)
{
  const QWidget* window = widget->window();
  if (!CanTellPress() || !widget->isVisible() || !window->internalWinId())
  {
    return false;
  }
  static const uint8_t inputExtension = InputExtension();
  const qreal scale = window->devicePixelRatioF();
  const QPoint corner = widget->mapTo(window, QPoint());
  Place place{ static_cast<xcb_window_t>(window->internalWinId()),
    QRect((QPointF(corner) * scale).toPoint(), (QSizeF(widget->size()) * scale).toSize()),
    inputExtension };
  return QX11Info::peekEventQueue(IsPressIn, &place);
}

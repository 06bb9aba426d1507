// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   InsideOutFirstLook
 * @brief   How the plugin's filters look after the first Apply.
 *
 * ParaView 5.11 then shows all outputs of a filter, each colored by its active array over the
 * array's range. For a solid it shows both the solid and its boundary at the same place, colored by
 * the rounding errors of a winding number that is 1 everywhere. Hints of a filter's proxy improve
 * this:
 *
 * - `FirstLook` of a `port`: `shown` is always (the default), never, or if_any, which is where it
 *   has cells; with a `color` (red, green, blue) it has that color, whatever its arrays are; an
 *   empty one is the color that ParaView gives; `by` is the array that colors it, with a legend;
 *   `representation` is ParaView's name of one. Results of the plugin's other filters on the same
 *   inputs are hidden. The inputs of a filter that failed or was stopped are shown again.
 * - `WindingNumberColors`: the colors of the array w go from -1 to 2, if it has none yet, and
 *   the user keeps none for it.
 * - `TakesHull`: made on a solid, the filter takes the hull of it, which is made for it.
 * - `FacesCamera` names a `property` whose plane faces the camera at first. ParaView's own has the
 *   normal x, and is seen from its edge.
 *
 * They hold once, and only for a filter that the user made in the window: scripts and states say
 * themselves what they show. A trace tells them as if the user had done it.
 */
#ifndef InsideOutFirstLook_h
#define InsideOutFirstLook_h

#include <QObject>

class pqPipelineSource;

class InsideOutFirstLook : public QObject
{
  Q_OBJECT

public:
  explicit InsideOutFirstLook(QObject* parent = nullptr);

  void startup(); ///< what ParaView calls once the plugin is loaded
  void shutdown();

private Q_SLOTS:
  void prepare(pqPipelineSource* filter);
};

#endif

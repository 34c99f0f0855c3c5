#pragma once

#include <QObject>
#include <QWidget>
#include <string_view>
#include <utility>

#include "ui/window/pages.h"

namespace alidade::ui {

class ArcChart;

/// The right column of the window: the picture of the arcs, with pages beside and below it (`allPages`).
class ResultColumn : public QObject {
  Q_OBJECT

 public:
  ResultColumn(const WindowParts& parts, const QWidget& window);

  QWidget* widget() const { return m_widget; }
  /// The tabs beside the picture and below it.
  QList<PageTabs*> tabs() const { return {m_beside, m_below}; }
  /// The tabs that contain the page with this id, and the index of the page in them.
  std::pair<PageTabs*, int> tab(std::string_view id) const;
  template <typename Panel>
  Panel* panel() const {
    return m_widget->findChild<Panel*>();
  }
  /// Brings the page to the front and gives it the keyboard.
  void showPage(std::string_view id);
  /// Commits unfinished entries.
  void commit();
  /// Shows the page that edits `place`; false if no page edits it.
  bool reveal(const Place& place, bool takeFocus);
  /// Asks to show and focus a reading.
  void select(std::size_t position, std::size_t row);
  /// If not `shown`, the pages below get the room of the picture and of the pages beside it.
  void setPictureShown(bool shown) { m_top->setVisible(shown); }

 signals:
  void commitWanted();  ///< asks to commit unfinished entries before the session is edited
  void revealWanted(const alidade::Place& place, bool takeFocus);

 private:
  void connectPicture(const WindowParts& parts);
  void connectCharts(const WindowParts& parts);

  QWidget *m_widget, *m_top;  ///< `m_top`: the picture and the pages beside it
  ArcChart* m_picture;
  PageTabs *m_beside, *m_below;
};

}  // namespace alidade::ui

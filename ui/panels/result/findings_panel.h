#pragma once

#include <QListWidget>
#include <vector>

#include "ui/jobs/evaluation.h"

namespace alidade::ui {

/// Everything that stands against the session or its result: entries that cannot be used, and what the data
/// say about themselves. A click or Enter leads to the place.
class FindingsPanel : public QListWidget {
  Q_OBJECT

 public:
  /// So many problems of a kind have a line each; one more line tells how many there are beyond.
  static constexpr std::size_t mostListed = 200;

  explicit FindingsPanel(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);
  /// What a diagnosis found; empty: no gap. Only then can all be sound.
  void setGap(const QString& headline);
  /// The session has changed: what was found is told as of before.
  void setGapStale();
  /// Another session: nothing is known of it yet.
  void clearGap();

 signals:
  void placeActivated(const alidade::Place& place);
  /// How many there are of what kind: "2 problems, 1 warning"; empty where there is one or none.
  void counted(const QString& text);
  void gapActivated();

 protected:
  void initViewItemOption(QStyleOptionViewItem* option) const override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Entry {
    QString icon, spoken, text;
    Place place = {};
    bool isGap = false;

    bool operator==(const Entry&) const = default;
  };

  enum class GapState { Unknown, Old, Known };

  static std::vector<Entry> entriesOf(const Evaluation& evaluation);
  static std::vector<Entry> problemEntries(const Evaluation& evaluation, bool missing);
  Entry gapEntry() const;
  void refresh();
  QString countText() const;
  bool saysSound() const;
  void add(const Entry& entry);
  void activate(int row);

  std::vector<Entry> m_found;    ///< of the evaluation
  std::vector<Entry> m_entries;  ///< as listed
  bool m_isSearched = false, m_hasSuspects = false;
  GapState m_gapState = GapState::Unknown;
  QString m_gapHeadline;  ///< empty: no gap
};

/// An entry still to be made, as opposed to one that cannot be used.
bool isMissing(const Session& session, const Place& place);

}  // namespace alidade::ui

#pragma once

#include <QListWidget>
#include <vector>

#include "core/evaluation/evaluation.h"

namespace alidade::ui {

/// All objections to the session or its result: unusable entries and findings from the data. A click or Enter
/// leads to the place.
class FindingsPanel : public QListWidget {
  Q_OBJECT

 public:
  /// At most this many problems of a kind have a line of their own; one more line counts the rest.
  static constexpr std::size_t mostListed = 200;

  explicit FindingsPanel(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);
  /// The headline of a diagnosis; empty: no gap. The list says "No problems." only after a diagnosis.
  void setGap(const QString& headline);
  /// The session changed: the old findings are marked as outdated.
  void setGapStale();
  /// Empties the list for another session, which is not diagnosed yet.
  void clearGap();
  /// The height that shows every line at the present width.
  int wholeHeight() const;

 signals:
  void placeActivated(const alidade::Place& place);
  /// Counts by kind: "2 problems, 1 warning"; empty for fewer than two lines.
  void counted(const QString& text);
  void gapActivated();
  void listed();  ///< the lines have changed

 protected:
  void initViewItemOption(QStyleOptionViewItem* option) const override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Entry {
    QString icon, accessible, text;
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

  std::vector<Entry> m_found;    ///< entries of the evaluation
  std::vector<Entry> m_entries;  ///< entries as listed
  bool m_isSearched = false, m_hasSuspects = false;
  GapState m_gapState = GapState::Unknown;
  QString m_gapHeadline;  ///< empty: no gap
};

/// True for an entry still to be made, false for an unusable one.
bool isMissing(const Session& session, const Place& place);

}  // namespace alidade::ui

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
  explicit FindingsPanel(QWidget* parent = nullptr);

  void setEvaluation(const Evaluation& evaluation);

 signals:
  void placeActivated(const alidade::Place& place);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Entry {
    QString icon, spoken, text;
    Place place;

    bool operator==(const Entry&) const = default;
  };

  static std::vector<Entry> entriesOf(const Evaluation& evaluation);
  bool saysSound() const;
  void add(const Entry& entry);

  std::vector<Entry> m_entries;
};

/// An entry still to be made, as opposed to one that cannot be used.
bool isMissing(const Session& session, const Place& place);

}  // namespace alidade::ui

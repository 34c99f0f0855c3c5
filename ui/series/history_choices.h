#pragma once

#include <QWidget>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/series/history/quantity_history.h"

class QComboBox;
class QLabel;
class QSpinBox;

namespace alidade::ui {

/// A row of choices for the history to draw: the device or instrument, if there are several, the quantity,
/// and how many of the first values are the baseline. When a list is replaced, the choice stays if possible.
class HistoryChoices : public QWidget {
  Q_OBJECT

 public:
  /// The words that differ between the histories of devices and of instruments.
  struct Words {
    QString owner, ownerLabel;  ///< "Device", "&Device"
    QString baseline;           ///< for screen readers: "Sessions in the baseline"
    QString all;                ///< a baseline of 0: "all sessions"
    QString tip;                ///< tool tip of the baseline
  };

  explicit HistoryChoices(const Words& words, QWidget* parent = nullptr);

  void setOwners(const QStringList& names);
  void setQuantities(const std::vector<QuantityHistory>& quantities);
  /// `most`: how many values a baseline can have.
  void setMostInBaseline(std::size_t most);
  void setBaseline(int values);

  /// Indices into the owners and quantities last set; absent if there are none.
  std::optional<std::size_t> owner() const;
  std::optional<std::size_t> quantity() const;
  int baseline() const;

 signals:
  void ownerChosen();
  void quantityChosen();
  void baselineChosen();

 private:
  QLabel* m_ownersLabel;
  QComboBox *m_owners, *m_quantities;
  QSpinBox* m_baseline;
};

}  // namespace alidade::ui

#pragma once

#include <QWidget>
#include <memory>

#include "core/series/shared_causes/series_diagnosis.h"

class QLabel;

namespace alidade::ui {

class StatementTable;
class StatementView;

using SharedSeriesDiagnosis = std::shared_ptr<const SeriesDiagnosis>;

/// The shared causes of sessions: the summary, the causes with their owners, each session alone and with the
/// others, and which session to measure next.
class DiagnosisPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DiagnosisPanel(QWidget* parent = nullptr);

  /// Null: no diagnosis, and `reason` says why.
  void setDiagnosis(const SharedSeriesDiagnosis& diagnosis, const QString& reason = {});

  StatementTable* causes() const { return m_causes; }
  StatementTable* sessions() const { return m_sessions; }

 signals:
  /// A session was activated: its index in the diagnosed files.
  void sessionWanted(std::size_t file);
  /// The user wants to save an offered effect as a file.
  void keepWanted(const alidade::OwnEffect& effect);

 private:
  void showOffers();

  SharedSeriesDiagnosis m_diagnosis;
  QLabel *m_sentence, *m_findings;
  QWidget* m_offers;  ///< a button for each effect
  StatementView *m_stages, *m_where, *m_advice, *m_undetectable;
  StatementTable *m_causes, *m_sessions;
};

}  // namespace alidade::ui

#pragma once

#include <QObject>

#include "core/statement/headline.h"
#include "ui/jobs/fit_job.h"
#include "ui/jobs/gap_job.h"

namespace alidade::ui {

class SessionDocument;
struct SessionChange;

/// Fits and diagnoses the current session after each change, and emits the results for the window.
class SessionJobs : public QObject {
  Q_OBJECT

 public:
  explicit SessionJobs(SessionDocument& document) : m_document(document) {}

  FitJob& fit() { return m_fit; }
  GapJob& gap() { return m_gap; }
  /// Evaluates the session now and after each change. Call after all views are connected.
  void start();
  /// Weighs the causes with the reference as evidence, or without it. Does nothing if they are weighed so.
  void setWithReference(bool wanted);
  /// Stops the search for misread readings and the diagnosis, whose results then stay unknown.
  void stop();

 signals:
  void begun();
  void evaluated(const alidade::ui::SharedEvaluation& evaluation);
  /// After each fit, and again after the search for misread readings.
  void suspectsChanged(const alidade::ui::SharedEvaluation& evaluation);
  void searchStopped();
  void headlineChanged(const alidade::Headline& headline);
  void gapChanged(const alidade::ui::SharedGap& gap);
  void gapAged();     ///< the session or the evidence changed: the gap shown is outdated
  void gapCleared();  ///< another session, not diagnosed yet

 private:
  void follow(const SessionChange& change);
  void show(const SharedEvaluation& evaluation);
  void showGap(const SharedGap& gap);
  bool showGapAgain(const SharedEvaluation& evaluation);
  void ageGap();
  void clearGap();
  void showProvisional();

  SessionDocument& m_document;
  FitJob m_fit;
  GapJob m_gap;
  SharedEvaluation m_shown;  ///< the newest; null before the first
  SharedGap m_completed;     ///< the last gap with its `dependences`; null if none with this evidence
  bool m_isGapOld = false;   ///< the gap shown is outdated
};

}  // namespace alidade::ui

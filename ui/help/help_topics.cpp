#include "ui/help/help_topics.h"

#include <QMetaObject>
#include <QVariant>
#include <QWidget>

#include "ui/language/languages.h"

namespace alidade::ui {

namespace {

QString topicOfClass(const QMetaObject* type) {
  for (; type; type = type->superClass())
    for (const ClassTopic& known : classTopics())
      if (qstrcmp(known.className, type->className()) == 0) return QString::fromLatin1(known.topic);
  return {};
}

}  // namespace

const std::vector<HelpPage>& allHelpPages() {
  static const std::vector<HelpPage> pages{
      {"first", QT_TRANSLATE_NOOP("HelpPage", "First measurement in ten steps")},
      {"entering", QT_TRANSLATE_NOOP("HelpPage", "Entering readings")},
      {"connection", QT_TRANSLATE_NOOP("HelpPage", "Readings from the instrument")},
      {"result", QT_TRANSLATE_NOOP("HelpPage", "The result and its verdict")},
      {"gap", QT_TRANSLATE_NOOP("HelpPage", "How to read the gap")},
      {"forms", QT_TRANSLATE_NOOP("HelpPage", "Forms: uncatalogued effects")},
      {"uncertainty", QT_TRANSLATE_NOOP("HelpPage", "Uncertainty and reliability")},
      {"known-sizes", QT_TRANSLATE_NOOP("HelpPage", "Known sizes and effects")},
      {"instrument", QT_TRANSLATE_NOOP("HelpPage", "Checking the instrument")},
      {"report", QT_TRANSLATE_NOOP("HelpPage", "Report, journal and seal")},
      {"series", QT_TRANSLATE_NOOP("HelpPage", "A device over time")},
      {"files", QT_TRANSLATE_NOOP("HelpPage", "Files and recovery")},
      {"installation", QT_TRANSLATE_NOOP("HelpPage", "Checking this installation")},
      {"words", QT_TRANSLATE_NOOP("HelpPage", "Words and symbols")}};
  return pages;
}

const std::vector<ClassTopic>& classTopics() {
  static const std::vector<ClassTopic> topics{{"alidade::ui::PositionTabs", "entering"},
                                              {"alidade::ui::ReadingsTable", "entering"},
                                              {"alidade::ui::ZeroEntries", "entering#zeros"},
                                              {"alidade::ui::SuspectBar", "entering#misread"},
                                              {"alidade::ui::FindingsPanel", "result#findings"},
                                              {"alidade::ui::ArcChart", "result#picture"},
                                              {"alidade::ui::SimulationBox", "uncertainty#simulation"},
                                              {"alidade::ui::FormList", "forms"},
                                              {"alidade::ui::BlindTrialDialog", "gap#trials"},
                                              {"alidade::ui::InstrumentDialog", "instrument"},
                                              {"alidade::ui::RecordHistoryDialog", "instrument"},
                                              {"alidade::ui::ConnectionDialog", "connection"},
                                              {"alidade::ui::ReadingQuestionBar", "connection#question"},
                                              {"alidade::ui::InstallationDialog", "installation"},
                                              {"alidade::ui::SeriesWindow", "series"},
                                              {"alidade::ui::DiagnosisPanel", "gap#several"},
                                              {"alidade::ui::ChangedFileBar", "files#others"},
                                              {"alidade::ui::StartPage", "first"}};
  return topics;
}

QUrl helpUrl(const QString& topic) {
  QUrl url(QStringLiteral("qrc:/help/%1/%2.html").arg(shownLanguage(), topic.section(u'#', 0, 0)));
  if (const QString place = topic.section(u'#', 1); !place.isEmpty()) url.setFragment(place);
  return url;
}

QString helpTopicOf(const QWidget* widget) {
  for (; widget; widget = widget->parentWidget()) {
    if (const QString own = widget->property("helpTopic").toString(); !own.isEmpty()) return own;
    if (const QString known = topicOfClass(widget->metaObject()); !known.isEmpty()) return known;
  }
  return firstHelpTopic();
}

QString firstHelpTopic() {
  return QString::fromLatin1(allHelpPages().front().id);
}

}  // namespace alidade::ui

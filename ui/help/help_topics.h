#pragma once

#include <QString>
#include <QUrl>
#include <vector>

class QWidget;

namespace alidade::ui {

/// A page of the guide.
struct HelpPage {
  const char* id;     ///< file name in each language folder of `:/help`, without suffix
  const char* title;  ///< in the context `HelpPage`
};

/// All pages in the order of the contents.
const std::vector<HelpPage>& allHelpPages();

/// The address of a topic, which is a page ("gap") or an anchor in a page ("words#s0").
QUrl helpUrl(const QString& topic);

/// The guide's topic for `widget`, else that of its nearest parent with a topic, else the first measurement.
/// A widget's topic is its property `helpTopic`, else the topic of its class.
QString helpTopicOf(const QWidget* widget);

/// The topic of the first page.
QString firstHelpTopic();

/// The topics of all widget classes.
QStringList helpTopicsOfClasses();

}  // namespace alidade::ui

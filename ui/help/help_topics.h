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

/// The topic of a class of widgets.
struct ClassTopic {
  const char* className;
  const char* topic;
};

const std::vector<ClassTopic>& classTopics();

/// The address of a topic, which is a page ("gap") or an anchor in a page ("words#s0").
QUrl helpUrl(const QString& topic);

/// The guide's topic for `widget`, else that of its nearest parent with a topic, else the first measurement.
/// A widget's topic is its property `helpTopic`, else the topic of its class.
QString helpTopicOf(const QWidget* widget);

/// The topic of the first page.
QString firstHelpTopic();

}  // namespace alidade::ui

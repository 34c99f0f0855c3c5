#pragma once

#include <QString>
#include <QUrl>
#include <vector>

class QWidget;

namespace alidade::ui {

/// A page of the guide.
struct HelpPage {
  const char* id;     ///< its file in the folder of each language in `:/help`, without suffix
  const char* title;  ///< in the context `HelpPage`
};

/// In the order of the contents.
const std::vector<HelpPage>& allHelpPages();

/// Where a topic stands: "gap", or a place in a page, "words#s0".
QUrl helpUrl(const QString& topic);

/// What the guide says of where the keyboard is: of the widget, else of what it is in; the first measurement
/// where neither has a topic. A widget has that of its property `helpTopic`, else that of its class.
QString helpTopicOf(const QWidget* widget);

/// The first page.
QString firstHelpTopic();

/// Every topic that a class of widgets has.
QStringList helpTopicsOfClasses();

}  // namespace alidade::ui

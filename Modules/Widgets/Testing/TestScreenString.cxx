#include "WindowTest.h"

#include <QAbstractItemView>
#include <QLabel>

// Names from files, in widgets that would interpret text as HTML.

namespace palpate::screen_string_test
{
namespace
{
using ScreenStringTest = test::WindowTest;

const std::string HostileName = "<b>evil</b>\n& \u202eliver [*]";

bool IsPlain(const QString& text)
{
  return !text.contains(QChar(0x202e)) && !text.contains("\n&");
}

TEST_F(ScreenStringTest, ShowsNamesAsPlainTextEverywhere)
{
  this->OpenPhantom();
  StudyState next = this->Study->State();
  next.Structures.at(0).Name = HostileName;
  this->Study->Change("Rename " + QString::fromStdString(HostileName), next);
  this->Settle();
  QApplication::processEvents();
  int seen = 0;
  for (const QLabel* label : this->Window->findChildren<QLabel*>())
  {
    EXPECT_TRUE(IsPlain(label->text())) << label->text().toStdString();
    EXPECT_TRUE(!label->text().contains("<b>evil") || label->textFormat() == Qt::PlainText);
  }
  for (const QWidget* widget : this->Window->findChildren<QWidget*>())
  {
    EXPECT_FALSE(widget->toolTip().contains("<b>evil")) << widget->toolTip().toStdString();
    EXPECT_TRUE(IsPlain(widget->toolTip())) << widget->toolTip().toStdString();
    seen += widget->toolTip().contains("&lt;b&gt;evil") ? 1 : 0;
  }
  EXPECT_GE(seen, 1) << "the test must check a tool tip with the name";
  for (const auto* view : this->Window->findChildren<QAbstractItemView*>())
  {
    const QAbstractItemModel* model = view->model();
    for (int row = 0; model != nullptr && row < model->rowCount(); ++row)
    {
      for (int column = 0; column < model->columnCount(); ++column)
      {
        const QString text = model->index(row, column).data().toString();
        EXPECT_TRUE(IsPlain(text)) << text.toStdString();
        seen += text.startsWith("<b>evil</b>\\x0a&") ? 1 : 0;
      }
    }
  }
  EXPECT_GE(seen, 2) << "the test must check a table with the name";
  EXPECT_EQ(this->Action("Undo")->text(),
            "&Undo: Rename <b>evil</b>\\x0a&& \\xe2\\x80\\xaeliver [*]");
}

TEST_F(ScreenStringTest, MessageAboutAFileIsOneLine)
{
  const auto file = this->Phantom.Folder / "a\n<b>b\u202e.nii.gz";
  test::WriteAll(file, "no image");
  this->Study->OpenFiles({file});
  WaitUntil([this] { return !this->Messages().empty(); });
  const std::string message = this->Messages();
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_NE(message.find("a\\x0a<b>b\\xe2\\x80\\xae.nii.gz"), std::string::npos) << message;
}
} // namespace
} // namespace palpate::screen_string_test

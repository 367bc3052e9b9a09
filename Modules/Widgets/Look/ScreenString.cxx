#include "ScreenString.h"

#include "ScreenText.h"

#include <QTextDocument>

namespace palpate
{
QString ScreenString(const std::string& text)
{
  return QString::fromStdString(Printable(text));
}

QString PlainToolTip(const QString& text)
{
  return text.isEmpty() ? text : Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal);
}

QString MenuString(const QString& text)
{
  return QString(text).replace('&', "&&");
}

QString TitleString(const QString& text)
{
  return QString(text).replace("[*]", "[*][*]");
}
} // namespace palpate

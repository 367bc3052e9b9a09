#include "StructureStatus.h"

#include "CheckText.h"
#include "TextContrast.h"

#include <QBrush>
#include <QGuiApplication>
#include <QPalette>
#include <QStringList>

#include <array>

namespace palpate
{
namespace
{
// In the order of OrganJudgement::Verdict. The colours are told apart by the colour-blind, too.
struct VerdictLook
{
  const char* Sign;
  const char* Color;
};
constexpr std::array<VerdictLook, 3> VerdictLooks{
    {{"\u2713", "gray"}, {"\u25B2", "#E69F00"}, {"\u2716", "#D5271D"}}};

const VerdictLook& LookOf(const StructureVerdict& verdict)
{
  return VerdictLooks.at(static_cast<std::size_t>(verdict.Is));
}
} // namespace

QString StructureStatus::Text() const
{
  QStringList parts;
  if (this->Verdict != nullptr)
  {
    parts += QString(LookOf(*this->Verdict).Sign) + " " + VerdictWord(this->Verdict->Is);
  }
  if (this->Cut)
  {
    parts += "cut by the scan";
  }
  if (!this->Drilled.isEmpty())
  {
    parts += this->Drilled;
  }
  return parts.join("; ");
}

QString StructureStatus::SortText() const
{
  const int rank =
      this->Verdict != nullptr && this->Verdict->Is != OrganJudgement::Verdict::Plausible
          ? 2 - static_cast<int>(this->Verdict->Is)
      : this->Cut                ? 2
      : !this->Drilled.isEmpty() ? 3
      : this->Verdict != nullptr ? 4
                                 : 5;
  return QString::number(rank) + " " + this->Text();
}

QString StructureStatus::ToolTip() const
{
  QStringList lines;
  if (this->Verdict != nullptr)
  {
    lines += QString(VerdictWord(this->Verdict->Is)) + ": " + this->Verdict->Sentence;
  }
  if (this->Cut)
  {
    lines += QString("cut by the border of the image: %1 mm\u00B2 of its surface")
                 .arg(*this->Cut, 0, 'f', *this->Cut < 10.0 ? 1 : 0);
  }
  if (!this->Drilled.isEmpty())
  {
    lines += this->Drilled;
  }
  return lines.join("\n");
}

QVariant StructureStatus::Color() const
{
  return this->Verdict != nullptr
             ? QVariant(QBrush(ReadableOn(QGuiApplication::palette().color(QPalette::Base),
                                          QColor(LookOf(*this->Verdict).Color))))
             : QVariant();
}
} // namespace palpate

#pragma once

#include <QLabel>

namespace palpate
{
/// A named label whose text is never taken for HTML.
QLabel* MakePlainLabel(const char* name, QWidget* parent);
} // namespace palpate

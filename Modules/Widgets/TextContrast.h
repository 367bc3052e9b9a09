#pragma once

#include <QColor>

namespace palpate
{
/// Of text that can be read by eyes that see a little less; 1 is none, 21 is black on white.
/// Source: Web Content Accessibility Guidelines 2.1, success criterion 1.4.3.
constexpr double LeastTextContrast = 4.5;

/// Of two colours, whichever is the text's, by their relative luminances (WCAG 2.1).
double ContrastRatio(const QColor& one, const QColor& other);

/// The colour, made darker or lighter until it can be read on that ground.
QColor ReadableOn(const QColor& ground, const QColor& color);
} // namespace palpate

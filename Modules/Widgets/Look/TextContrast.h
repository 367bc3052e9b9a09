#pragma once

#include <QColor>

namespace palpate
{
/// Minimum contrast of text for readers with moderately low vision; 1 is none, 21 is black on
/// white. Source: Web Content Accessibility Guidelines 2.1, success criterion 1.4.3.
constexpr double LeastTextContrast = 4.5;

/// Contrast of two colours in either order, by their relative luminances (WCAG 2.1).
double ContrastRatio(const QColor& one, const QColor& other);

/// The colour, made darker or lighter until it is readable on that background.
QColor ReadableOn(const QColor& ground, const QColor& color);
} // namespace palpate

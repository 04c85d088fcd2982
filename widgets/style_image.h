#pragma once

#include <QIcon>
#include <QImage>

#include <memory>

namespace limner {

struct Figure;
struct TransferNode;
class LitSphere;

/// A lit sphere as a ball of that many device pixels, with a soft edge, on nothing.
QImage styleBall(const LitSphere& sphere, int pixels);
/// A ball of one colour.
QImage colourBall(const QColor& colour, int pixels);
/// What a node shows, on white as on paper: its style, its colour, or grey where the style is missing.
QImage nodeBall(const Figure& figure, const TransferNode& node, int pixels);
/// The mean colour of the same.
QColor nodeColour(const Figure& figure, const TransferNode& node);

} // namespace limner

#pragma once

#include <QString>

#include <optional>

namespace limner {

/// How well what was typed names a command. Case and accents do not count. Every word typed has to be found: at the
/// start of one of the name's words best, inside one next, then as letters in their order. Null: it does not name it.
/// Larger is better; among equals the shorter name is the better one.
std::optional<double> matchScore(const QString& typed, const QString& name);

} // namespace limner

// Random fields, and fields turned by an element of a group.
#pragma once

#include <algorithm>
#include <cmath>

#include "learned/groups/group.hpp"
#include "learned/kernels/planes.hpp"
#include "learned/layers/uniform.hpp"

namespace praxis::learned {

template <class T>
void randomise(Planes<T>& planes, Random& random) {
    for (int channel = 0; channel < planes.channels(); ++channel)
        for (int row = 0; row < planes.height(); ++row)
            for (int column = 0; column < planes.width(); ++column)
                planes.at(channel, row, column) = static_cast<T>(uniform(random, -1, 1));
}

/// Where a cell of a square map of `size` goes.
inline Offset turned_cell(const Group& group, int g, Offset cell, int size) {
    const Offset twice = group.apply(g, {2 * cell.row - (size - 1), 2 * cell.column - (size - 1)});
    return {(twice.row + size - 1) / 2, (twice.column + size - 1) / 2};
}

/// result = g planes, for fields of a representation.
template <class T>
void turn(const Group& group, const Representation& representation, int g, const Planes<T>& planes,
          Planes<T>& result) {
    const int fields = planes.channels() / representation.size, size = planes.height();
    for (int channel = 0; channel < planes.channels(); ++channel)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const Offset to = turned_cell(group, g, {row, column}, size);
                result.at(representation(g, channel / fields) * fields + channel % fields, to.row,
                          to.column) = planes.at(channel, row, column);
            }
}

template <class T>
double largest_difference(const Planes<T>& a, const Planes<T>& b) {
    double largest = 0;
    for (int channel = 0; channel < a.channels(); ++channel)
        for (int row = 0; row < a.height(); ++row)
            for (int column = 0; column < a.width(); ++column)
                largest = std::max(largest, std::abs(static_cast<double>(a.at(channel, row, column)) -
                                                     static_cast<double>(b.at(channel, row, column))));
    return largest;
}

template <class T>
double dot(const Planes<T>& a, const Planes<T>& b) {
    double sum = 0;
    for (int channel = 0; channel < a.channels(); ++channel)
        for (int row = 0; row < a.height(); ++row)
            for (int column = 0; column < a.width(); ++column)
                sum += static_cast<double>(a.at(channel, row, column)) *
                       static_cast<double>(b.at(channel, row, column));
    return sum;
}

}  // namespace praxis::learned

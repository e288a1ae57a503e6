#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace limpid::gl {

/// A SPIR-V module in which a * b + c, a * b - c and c - a * b of 32-bit floats are rounded once (in 64 bits)
/// where nothing is decorated NoContraction, which is what `precise` becomes. So a compiler may do it; Mesa's
/// does not.
class Contracted {
  public:
    using Words = std::vector<std::uint32_t>;

    explicit Contracted(const Words& module) : _head(module.begin(), module.begin() + 5) {
        std::vector<Words> all;
        for (auto at = module.begin() + 5; at != module.end(); at += *at >> 16)
            all.emplace_back(at, at + (*at >> 16));
        for (const Words& i : all)
            learn(i);
        for (const Words& i : all)
            if (!contract(i)) _out.push_back(i);
    }

    int count() const { return _count; }

    Words words() const {
        Words words = _head;
        const auto add = [&](const Words& i) { words.insert(words.end(), i.begin(), i.end()); };
        add(make(Capability, {float64}));
        bool functions = false;
        for (const Words& i : _out) {
            if (op(i) == Function && !std::exchange(functions, true))
                for (const Words& type : _types)
                    add(type);
            add(i);
        }
        return words;
    }

  private:
    enum Op : std::uint32_t { // of the SPIR-V specification, 3.42
        Capability = 17,
        TypeFloat = 22,
        TypeVector = 23,
        Function = 54,
        Decorate = 71,
        CompositeConstruct = 80,
        FConvert = 115,
        FAdd = 129,
        FSub = 131,
        FMul = 133,
        VectorTimesScalar = 142
    };
    static constexpr std::uint32_t float64 = 10, noContraction = 42;

    static std::uint32_t op(const Words& i) { return i[0] & 0xffff; }
    static Words make(std::uint32_t op, Words rest) {
        rest.insert(rest.begin(), std::uint32_t(rest.size() + 1) << 16 | op);
        return rest;
    }
    std::uint32_t next() { return _head[3]++; }

    void learn(const Words& i) {
        if (op(i) == Decorate && i[2] == noContraction) _precise.insert(i[1]);
        if (op(i) == TypeFloat) (i[2] == 32 ? _float : _double) = i[1];
        if (op(i) == TypeVector) _vectors[{i[2], i[3]}] = i[1];
        if (op(i) == FMul || op(i) == VectorTimesScalar) _products[i[2]] = i;
    }
    /// Components of a type of floats, 0 for another.
    unsigned sizeOf(std::uint32_t type) const {
        if (type == _float) return 1;
        for (const auto& [vector, id] : _vectors)
            if (id == type && vector.first == _float) return vector.second;
        return 0;
    }
    std::uint32_t wide(unsigned size) {
        if (!_double) _types.push_back(make(TypeFloat, {_double = next(), 64}));
        if (size == 1) return _double;
        std::uint32_t& id = _vectors[{_double, size}];
        if (!id) _types.push_back(make(TypeVector, {id = next(), _double, size}));
        return id;
    }
    std::uint32_t emit(std::uint32_t op, std::uint32_t type, Words operands) {
        const std::uint32_t id = next();
        operands.insert(operands.begin(), {type, id});
        _out.push_back(make(op, operands));
        return id;
    }
    bool contract(const Words& i) {
        if ((op(i) != FAdd && op(i) != FSub) || _precise.contains(i[2])) return false;
        const unsigned size = sizeOf(i[1]);
        for (const std::size_t side : {3, 4}) {
            const auto found = _products.find(i[side]);
            if (size == 0 || found == _products.end() || _precise.contains(found->first)) continue;
            const Words& product = found->second;
            std::uint32_t factor = product[4];
            if (op(product) == VectorTimesScalar)
                factor = emit(CompositeConstruct, i[1], Words(size, product[4]));
            const std::uint32_t type = wide(size);
            const std::uint32_t a = emit(FConvert, type, {product[3]}), b = emit(FConvert, type, {factor});
            const std::uint32_t ab = emit(FMul, type, {a, b}), c = emit(FConvert, type, {i[7 - side]});
            const std::uint32_t sum = emit(op(i), type, side == 3 ? Words{ab, c} : Words{c, ab});
            _out.push_back(make(FConvert, {i[1], i[2], sum}));
            ++_count;
            return true;
        }
        return false;
    }

    Words _head;
    std::vector<Words> _out, _types;
    std::set<std::uint32_t> _precise;
    std::map<std::pair<std::uint32_t, unsigned>, std::uint32_t> _vectors; ///< by component and size
    std::map<std::uint32_t, Words> _products;
    std::uint32_t _float = 0, _double = 0;
    int _count = 0;
};

} // namespace limpid::gl

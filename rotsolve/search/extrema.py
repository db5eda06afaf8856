"""Extrema: `x where Q is largest` and `largest Q`: where the derivative by a letter vanishes, or the letter is at an end of its domain."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Decimal, Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.equation import FOUND
from rotsolve.core.faults import Unsolvable
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import asked_symbol
from rotsolve.language.problem import EXTREMES, Condition, Find, references
from rotsolve.motion.rubs import rubs
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.questions.find import Asked, question_for
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.extreme_curve import Curve
from rotsolve.search.extreme_place import best_place, flatness, may_bend
from rotsolve.search.search import Search
from rotsolve.solver.steps import Found, Ref, Step

SIZE = "size of"
LONG = 60  # nodes of a derivative that is written out though its roots are found numerically


class Conclusion(Struct, frozen=True):
    """The line of a condition: "dB/dx = 0", what that comes to as an equation, and why it is this root."""

    said: str
    equation: Equality
    reason: Words


def by_condition(
    search: Search, question: Asked, found: Found, line: Conclusion, quantity: Answered, *, aside: bool
) -> Answered:
    """An answer that solves what an answer before it, as a function of a letter, has to fulfil."""
    if found.number is None:
        value, relation = found.formula, "="
    else:
        value, relation = Decimal(found.number.text()), "≈"
    assert value is not None
    told = [line.equation] if found.number is None or length(line.equation.left) <= LONG else []
    chain = (*told, Equality(Symbol(question.letter), value, relation))
    steps = add_step(search, question, ("words", line.said), (ref_of(quantity, search),), chain, line.reason)
    return remember_answer(search, Answered(question, found, (), steps, aside=aside))


def add_step(
    search: Search, asked: Asked, target: Ref, sources: Sequence[Ref], chain: Sequence[Equality], reason: Words
) -> tuple[int, int]:
    """The line of algebra, and where it stands among the steps."""
    steps = search.solver.steps
    steps.append(Step(len(steps) + 1, target, tuple(sources), tuple(chain), asked.letter, asked.section, reason))
    return len(steps) - 1, len(steps)


def remember_answer(search: Search, answered: Answered) -> Answered:
    """Remember an answer for the next question."""
    search.solver.solved[answered.asked.letter] = answered.found
    search.known.add(answered.asked.letter)
    search.answered.append(answered)
    return answered


def ref_of(answered: Answered, search: Search) -> Ref:
    """The step that gave an answer, or its one law where it needed none."""
    steps = search.solver.steps[slice(*answered.steps)]
    return ("step", steps[-1].number) if steps else ("law", answered.used[0])


def forget(answered: Answered, search: Search) -> None:
    """Let a quantity be settled anew from its closed form, since a letter in that has got a value."""
    letter, formula = answered.asked.letter, answered.found.formula
    search.solver.solved.pop(letter, None)
    search.known.discard(letter)
    if formula is not None:
        result = FOUND.equation(Symbol(letter), formula, answered.asked.section, cost=1)
        search.solver.derived.append((result, ref_of(answered, search)))
        search.remember()


def over_a_letter(find: Find, search: Search) -> bool:
    """Whether a question is for the largest or smallest value of a quantity at a place that has no value."""
    return bool(find.extreme) and bool(free_letters(find, search))


def free_letters(find: Find, search: Search) -> list[str]:
    """Letters without a value that say at which place of a rod a quantity is asked, or on which an earlier answer depends."""
    formulas = [point.argument for point in references(find.terms) if point.argument is not None]
    earlier = next((item for item in search.answered if Symbol(item.asked.find.name) == find.formula), None)
    if earlier is not None:
        sought = [letter for formula, letter, _ in search.extrema if formula == earlier.asked.formula]
        formulas += [Symbol(letter) for letter in sought] or [earlier.found.formula or ZERO]
    names = {name for formula in formulas for name in formula.symbols()}
    found = sorted(name for name in names if name in search.givens and name not in search.values)
    return found or ([] if earlier or not at_one_moment(find, search) else letters_looked_over(find, search))


def at_one_moment(find: Find, search: Search) -> bool:
    """Whether a quantity is asked that has one value for each value of a letter: at a moment, or of an event; of no steady precession."""
    timeline, space = search.scene.configuration.timeline, search.scene.configuration.problem.space
    events = {event.name for event in search.scene.configuration.problem.events}
    if space:
        from rotsolve.space.arrangement import NODAL
    for term in find.terms:
        state = next((state for state in timeline.states if term.at in (None, state.name)), None)
        lasts = term.start or (term.during and term.during not in events)
        if lasts or (space and state is not None and state.steady and term.path.quantity in NODAL):
            return False
    return bool(find.terms)


def letters_looked_over(find: Find, search: Search) -> list[str]:
    """The letters of the scene over which a quantity may be looked at: those that are `unknown`, else the only one without a value; none
    that another question settles, but for one of this very extreme."""
    settled: dict[str, list[Find]] = {}
    for other in search.scene.configuration.problem.finds:
        if other.seeks in search.givens and search.givens[other.seeks].asked:
            settled.setdefault(other.seeks, []).append(other)
    free = [name for name in search.givens if name not in search.values]
    free = [name for name in free if len(settled.get(name, ())) != 1 or same_extreme(find, settled[name][0], search)]
    unknown = [name for name in free if search.givens[name].asked]
    return sorted(unknown) or (free if len(free) == 1 else [])


def same_extreme(find: Find, place: Find, search: Search) -> bool:
    """Whether `largest Q` asks for the value at the place of which `x where Q is largest` asks."""
    condition = place.where
    if condition is None or condition.phrase is None or condition.word != find.extreme:
        return False
    asked, sought = (
        question_for(one, search.scene, search.letters()).formula for one in (plainly(find), condition.phrase)
    )
    return asked == sought


def plainly(find: Find) -> Find:
    """A question without the word for its extreme."""
    terms = tuple(replace(term, modifier="" if term.modifier in EXTREMES else term.modifier) for term in find.terms)
    return replace(find, modifier="", terms=terms)


def extreme_value(search: Search, find: Find) -> None:
    """`largest Q` over the one free letter of Q: its value at the place of the extremum."""
    letters, word = free_letters(find, search), find.extreme
    if len(letters) != 1:
        raise NotYet(f"`{find.text.strip()}` is open over several letters: {', '.join(letters)}")
    phrase = plainly(find)
    if letters[0] in search.solver.solved:
        at_settled_place(search, phrase, letters[0], word)
        return
    quantity = answer_over(search, phrase, letters[0])
    place = search.extrema.get((quantity.asked.formula, letters[0], word))
    if place is None:
        name = fresh(f"{letters[0]}_{'max' if word == 'largest' else 'min'}", search)
        condition = Condition(None, word=word, span=find.span, phrase=phrase)
        own = Find(name, Symbol(letters[0]), (), where=condition, text=letters[0], span=find.span)
        place = place_of_extremum(search, own, aside=True)
    at, curve = place.found.formula or Symbol(place.asked.letter), quantity.found.formula
    assert curve is not None
    letter = Symbol(asked_symbol(find.name))
    value = search.solver.simplify(curve.substitute({letters[0]: at}))
    question = Asked(find, letter, letter.name, quantity.asked.dimension, section=quantity.asked.section)
    line = (Equality(letter, curve.substitute({letters[0]: at})), Equality(letter, value))
    steps = add_step(search, question, ref_of(quantity, search), (ref_of(place, search),), line, ())
    remember_answer(search, Answered(question, Found(letter.name, value), (), steps))


def at_settled_place(search: Search, phrase: Find, letter: str, word: str) -> None:
    """The extreme value once the letter has the value that makes it so."""
    question = question_for(phrase, search.scene, search.letters())
    if (question.formula, letter, word) not in search.extrema:
        raise NotYet(f"`{letter}` has been settled by another condition: this quantity has one value only")
    search.answer(question)


def place_of_extremum(search: Search, find: Find, *, aside: bool = False) -> Answered:
    """`x where Q is largest`: where dQ/dx = 0 or at an end, whichever gives most."""
    condition = find.where
    assert condition is not None and condition.phrase is not None and condition.word is not None
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    if letter not in search.givens or letter in search.values:
        raise NotYet(
            "an extremum is over a letter of the scene that has no value",
            help="write `x where Q is largest`, with `x: unknown` or `x: m` under `given`",
        )
    refuse_told(letter, search)
    quantity, curve = as_function_of(search, condition.phrase, letter)
    smooth = search.solver.simplify(curve**2) if may_bend(curve, letter) else curve
    slope = search.solver.simplify(differentiate(smooth, letter))
    said, shown = flatness(name_to_text(quantity.asked.find.name), curve, letter, slope, search)
    given = search.givens[letter]
    own = asked_symbol(find.name) if aside else own_letter(search, find, letter)
    course = Curve(letter, Symbol(quantity.asked.letter), curve, slope, smooth, search)
    place, reason = best_place(course, condition.word, find.modifier, only=not aside)
    # else it is at an end, where nothing needs to vanish
    flat = place.number is not None or is_zero(shown.substitute({letter: place.at}), search.solver.positive)
    equation = Equality(shown.substitute({letter: Symbol(own)}) if flat else shown, ZERO)
    question = Asked(find, Symbol(own), own, given.dimension, section=quantity.asked.section)
    found = Found(own, None if place.number else place.at, place.number)
    answered = by_condition(search, question, found, Conclusion(said, equation, reason), quantity, aside=aside)
    search.extrema[(quantity.asked.formula, letter, condition.word)] = answered
    if own == letter:
        forget(quantity, search)  # from here on the letter has its value, and the quantity that of this place
    return answered


def seekers(search: Search, find: Find, letter: str) -> list[Find]:
    """The other questions that seek a letter which the scene has as an unknown."""
    finds = search.scene.configuration.problem.finds if search.givens[letter].asked else ()
    return [other for other in finds if other.seeks == letter and other.name != find.name]


def refuse_told(letter: str, search: Search) -> None:
    """Refuse an extremum over an unknown letter that the laws tell, so that it can not be any other."""
    if not search.givens[letter].asked or letter in search.known:
        return
    try:
        told = search.another(search.families).value_of(letter) is not None
    except NoAnswer:
        return
    except Unsolvable:
        told = True
    if told:
        raise NotYet(
            f"`{letter}` is settled by the laws, so that nothing is largest or smallest over it",
            help=f"ask for `{letter}` itself",
        )


def own_letter(search: Search, find: Find, letter: str) -> str:
    """The letter of an answer under a condition: that which the scene has as `unknown`, its own where several questions seek it."""
    search.separate |= {find.name} if seekers(search, find, letter) else set()
    return letter if search.givens[letter].asked and find.name not in search.separate else asked_symbol(find.name)


def as_function_of(search: Search, phrase: Find, letter: str) -> tuple[Answered, Formula]:
    """The quantity of a phrase, and its closed form as a function of a letter."""
    quantity = answer_over(search, phrase, letter)
    curve, said = quantity.found.formula, as_asked(phrase)
    if curve is None:
        raise NotYet(f"`{said}` is no function of `{letter}` in closed form")
    if letter not in curve.symbols():
        if rubs(search.scene.configuration):
            message = f"how things rub hangs on `{letter}`: over its whole range `{said}` is no one function of it"
            raise NotYet(message, help=f"ask for `{said}` with some numbers for `{letter}`")
        raise NotYet(f"`{said}` does not depend on `{letter}`")
    return quantity, curve


def as_asked(phrase: Find) -> str:
    """A quantity as the scene writes it, without what is said of it."""
    if len(phrase.terms) == 1 and phrase.formula == Symbol("#0"):
        return path_text(phrase.terms[0].path)
    return phrase.text.split(" is ")[0].split("=")[0].removeprefix("largest ").removeprefix("smallest ").strip()


def answer_over(search: Search, phrase: Find, letter: str) -> Answered:
    """The quantity of a phrase while a letter has no value, settled on the way where no question asks for it."""
    question = question_for(phrase, search.scene, search.letters())
    sized = may_lose_bars(phrase)  # where an answer that is no answer on the way may have lost them
    for item in (one for one in search.answered if one.aside or not sized):
        if question.formula in (item.asked.formula, Symbol(item.asked.letter)):
            return item
    word = QUANTITIES[phrase.terms[0].path.quantity].letter if len(phrase.terms) == 1 else "Q"
    find = replace(phrase, name=fresh(word, search))
    question = question_for(find, search.scene, search.letters())
    settled = letter in search.known
    search.known.add(letter)
    search.signs.free.add(letter)
    try:
        return search.answer(question, aside=True)
    finally:
        search.signs.free.discard(letter)
        if not settled:
            search.known.discard(letter)


def may_lose_bars(phrase: Find) -> bool:
    """Whether a size is asked, or a speed, of what may have either sign."""
    sizes = (term.modifier == SIZE or term.path.quantity == "speed" for term in phrase.terms)
    return phrase.modifier == SIZE or any(sizes)


def fresh(name: str, search: Search) -> str:
    """A name that neither a given nor a question has."""
    problem = search.scene.configuration.problem
    taken = {*search.givens, *(find.name for find in problem.finds)}
    taken |= {item.asked.find.name for item in search.answered}
    return next(word for word in (name, *(f"{name}_{number}" for number in range(1, 100))) if word not in taken)

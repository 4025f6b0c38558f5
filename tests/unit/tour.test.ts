import { describe, expect, it } from 'vitest';
import { FIGURES } from '../../web/app/guide/figures.ts';
import { TOUR } from '../../web/app/guide/tour.ts';
import { bendingUnit } from '../../web/app/panels/bending-figure.ts';
import { guideLink } from '../../web/app/sources/page-link.ts';
import { readPermalink } from '../../web/app/sources/permalink.ts';

describe('the tour', () => {
  it('has ten steps, each with its own link', () => {
    expect(TOUR.map(({ link }) => guideLink(`#${link}`))).toEqual(TOUR.map(({ link }) => link));
    expect(new Set(TOUR.map(({ link }) => link)).size).toBe(10);
    expect(guideLink('#sample=cactus&tour=1')).toBeNull();
  });

  it.each(TOUR.map((step) => [step.title, step] as const))('%s: has 25 to 60 words', (_, { text, sentence }) => {
    const words = text.split(/\s+/).length;
    expect(words).toBeGreaterThanOrEqual(25);
    expect(words).toBeLessThanOrEqual(60);
    expect(sentence).toMatch(/\.$/);
  });

  it.each(TOUR.map((step) => [step.title, step] as const))(
    '%s: has an equation, and a sentence of it',
    (_, { formula }) => {
      expect(formula!.math).toMatch(/^<mrow>.*<\/mrow>$/);
      const open: string[] = [];
      for (const [, end, tag, alone] of formula!.math.matchAll(/<(\/?)(\w+)[^>]*?(\/?)>/g)) {
        if (end) expect(open.pop()).toBe(tag);
        else if (!alone) open.push(tag!);
      }
      expect(open).toEqual([]);
      expect(formula!.words).toMatch(/^[A-Z].{20,}\.$/);
    },
  );

  it.each([...TOUR, ...FIGURES].map((step) => [step.title, step] as const))(
    '%s: its state is a link that plays, unless it is a film strip',
    (_, { state }) => {
      const link = readPermalink(state)!;
      expect(link.unfit).toEqual([]);
      expect(link.view.compare?.join(',') ?? null).toBe(new URLSearchParams(state).get('compare'));
      expect(link.playing).toBe(!link.view.film);
      expect(link.between![0]).toBeLessThanOrEqual(link.time!);
    },
  );
});

describe('the figures of the paper', () => {
  it('are complete, each with its own link', () => {
    const numbers = FIGURES.map(({ link }) => link.replace('figure=', ''));
    expect(numbers).toEqual(['1', '2a', '2b', '3', '4', '5', '6', '7', '8', '9', '10']);
    expect(FIGURES.map(({ link }) => guideLink(link))).toEqual(FIGURES.map(({ link }) => link));
  });

  it('count systems like the tour, and state where the heights of curves have no meaning', () => {
    const sentenceOf = (link: string): string => FIGURES.find((one) => one.link === link)!.sentence;
    for (const text of [TOUR[9]!.title, sentenceOf('figure=10')]) expect(text).toMatch(/\btwo systems\b/i);
    expect(sentenceOf('figure=9')).toMatch(/by edge lengths and angles/);
    expect(bendingUnit(['lri', 'geodesic'], null)).not.toMatch(/own coordinates/);
    expect(bendingUnit(['lri', 'geodesic', 'cubic-vertex'], 0.1)).toMatch(/own coordinates; logarithmic/);
  });
});

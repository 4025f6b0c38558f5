export const reports: string;
